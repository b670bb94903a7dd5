#pragma once

#include "scene/scene.hpp"

/// Meshes and kernels count positions in single precision, which is fine only near the point that
/// they count from: Scene::origin, a point near the eye. Patterns of the ground, plants, waves and
/// clouds go by the place over the terrain instead, so that they lie the same from every origin.
namespace aerostat::scene {

/// The origin for what is near a position: the terrain's centre at sea level, or, for every axis
/// along which the position is 8192 m or more away from it, the nearest whole multiple of 4096 m
/// from there. It moves in few, long steps because all meshes are built anew when it does.
dvec3 origin_near(const Scene& scene, const dvec3& position);

/// That of a picture, near the eye (of parallel rays: the target). All heights of the scene must
/// count from the sea.
dvec3 origin_for(const Scene& scene);

/// That of exported meshes, near the balloon, or the terrain's centre if there is none: it does not
/// depend on the camera.
dvec3 origin_for_export(const Scene& scene);

/// The place over the terrain of a position: as seen from the terrain's centre at sea level. That
/// of the origin which origin_for chooses is exact in single precision.
dvec3 place_of(const Scene& scene, const dvec3& position);

/// The scene as meshes are built from it: positions, the terrain's centre and base and the sea's
/// level count from the origin. Heights in rules (of snow, beaches, clouds, fog) are left as they
/// are.
Scene counted_from_origin(Scene scene);

}  // namespace aerostat::scene
