#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/scene.hpp"

/// From a scene to the triangles that are rendered and exported.
namespace aerostat::world {

/// One object of the world: a mesh and what it is.
struct Object {
  scene::ObjectId id = scene::ObjectId::terrain;
  mesh::TriangleMesh mesh;
  std::uint32_t grid_cells = 0;  // per side, if the mesh is such a grid as bvh::build_grid takes
};

/// The objects that are built, moved and thrown away together; shared because an edit of the scene
/// keeps the groups it does not touch.
using Group = std::shared_ptr<const std::vector<Object>>;

struct World {
  Group land;     // terrain and water
  Group balloon;  // null if there is none
};

/// Builds the world of a resolved scene. Groups of `previous` are kept if `previous_scene` asked
/// for the same ones. Runs on all cores. Throws Error{exhausted} if memory does not suffice.
World build(const scene::Scene& scene, const World* previous = nullptr,
            const scene::Scene* previous_scene = nullptr);

/// Fills in what depends on the terrain: positions given above the ground become positions above
/// the sea, and the basket view gets its camera.
void resolve(scene::Scene& scene);

}  // namespace aerostat::world
