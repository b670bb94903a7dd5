#pragma once

#include <cstdint>
#include <vector>

#include "image/film.hpp"
#include "scene/scene.hpp"
#include "world/group.hpp"

/// Renders objects that stand alone, far above a land that is out of sight, in an even light.
namespace aerostat::test {

inline constexpr int kLoneWidth = 96, kLoneHeight = 64;

/// Returns a ball with smooth normals. Its normals point inwards if `radius` is negative.
mesh::TriangleMesh ball(const vec3& centre, float radius = 1.0f);

/// Returns an object of the envelope's material, which lone_scene() makes plain.
world::Object plain_object(mesh::TriangleMesh mesh);

/// Returns a scene that looks at the origin from 6 m. The material of the envelope is white and
/// reflects all light evenly.
scene::Scene lone_scene();

/// Returns the film of objects in light of the radiance `sky` from everywhere, without sun and air.
/// `plain_paths` is 0 or one of AERO_PATHS_...
image::Film lone_film(world::Objects objects, const scene::Scene& scene, float sky,
                      std::uint32_t plain_paths = 0);

}  // namespace aerostat::test
