#pragma once

#include "scene/scene.hpp"

/// Meshes and kernels count positions in single precision, which is fine only near the point that
/// they count from: Scene::origin, a point near the eye. Patterns of the ground, plants, waves and
/// clouds go by the place over the terrain instead, so that they lie the same from every origin.
namespace aerostat::scene {

/// The origin for a scene whose heights all count from the sea: the terrain's centre at sea level,
/// or, for every axis along which the eye (of parallel rays: the target) is 8192 m or more away
/// from it, the nearest whole multiple of 4096 m from there. It moves in few, long steps because
/// all meshes are built anew when it does.
dvec3 origin_for(const Scene& scene);

/// The place over the terrain of a position: as seen from the terrain's centre at sea level. That
/// of the origin which origin_for chooses is exact in single precision.
dvec3 place_of(const Scene& scene, const dvec3& position);

/// The scene as meshes are built from it: positions, the terrain's centre and base and the sea's
/// level count from the origin. Heights in rules (of snow, beaches, clouds, fog) are left as they
/// are.
Scene counted_from_origin(Scene scene);

}  // namespace aerostat::scene
