#pragma once

#include "core/math.hpp"
#include "scene/resolved_scene.hpp"

/// These functions choose the origin that positions are counted from. Meshes and kernels hold
/// positions in single precision, which is exact enough only near their origin. That origin is
/// ResolvedScene::origin(), a point near the eye. Patterns of the ground, plants, waves and clouds
/// use the place over the terrain instead, so that they stay in place when the origin moves.
namespace aerostat::scene {

struct Scene;

/// Returns the origin for objects near a position. It is the terrain's centre at sea level if the
/// position is less than 8192 m away along every axis. Along an axis on which it is farther away,
/// the origin moves by the nearest whole multiple of 4096 m. These steps are few and long because
/// all meshes are built anew when the origin moves.
dvec3 origin_near(const Scene& scene, const dvec3& position);

/// Returns the origin of a picture, near the eye. For parallel rays, it is near the target. It is a
/// part of resolving a scene: the camera must have a position and a target above the sea already.
dvec3 origin_for(const Scene& scene);

/// Returns the origin of exported meshes. It is near the first balloon, or near the terrain's
/// centre if there is no balloon, and does not depend on the camera.
dvec3 origin_for_export(const ResolvedScene& scene);

/// Returns the place of a position over the terrain, counted from the terrain's centre at sea
/// level. The place of an origin that origin_for chooses is exact in single precision.
dvec3 place_of(const Scene& scene, const dvec3& position);

/// Returns the scene that meshes are built from. Positions, the terrain's centre and base, and
/// the sea's level count from the origin. Heights in rules (of snow, beaches, clouds, fog) stay
/// as they are.
Scene counted_from_origin(const ResolvedScene& scene);

}  // namespace aerostat::scene
