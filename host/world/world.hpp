#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "mesh/grid_mesh.hpp"
#include "mesh/mesh.hpp"
#include "scatter/scatter.hpp"
#include "scene/scene.hpp"
#include "world/surface.hpp"

/// From a scene to the triangles that are rendered and exported.
namespace aerostat::world {

/// One object of the world: a mesh, what it is and what it is made of.
struct Object {
  scene::ObjectId id = scene::ObjectId::terrain;
  scene::MaterialId material = scene::MaterialId::terrain;
  mesh::TriangleMesh mesh;
};

/// The ground and what lies on it.
struct Land {
  std::shared_ptr<const mesh::GridMesh> ground;
  std::vector<Object> objects;  // the water
};

using Objects = std::vector<Object>;

/// What grows on the ground, as models that stand there many times.
struct Plants {
  Objects models;
  std::vector<scatter::Instance> instances;  // `model` counts in `models`
};

/// Positions count from Scene::origin.
///
/// What is built, moved and thrown away together is shared, because an edit of the scene keeps what
/// it does not touch.
struct World {
  std::shared_ptr<const Land> land;
  std::shared_ptr<const Objects> balloon;  // and all further ones; null if there is none
  std::shared_ptr<const Plants> plants;    // null if there are none
};

/// Whether two scenes stand on the same land and sea, whatever their meshes count from.
bool same_land(const scene::Scene& a, const scene::Scene& b);

/// Builds the world of a resolved scene, with plants everywhere or in sight. Parts of `previous`
/// are kept if `previous_scene` asked for the same ones in the same places and had the same origin;
/// its land must have been carved alike. Runs on all cores; may be given up (core/stop_scope.hpp).
/// Throws Error{exhausted} if memory does not suffice.
World build(const scene::Scene& scene, const World* previous = nullptr,
            const scene::Scene* previous_scene = nullptr,
            scatter::Where where = scatter::Where::everywhere, Carving carving = Carving::fine);

/// Whether plants are among what is written out as triangles.
enum class Grown { left_out, included };

/// The world as triangles, the ground first, and if asked for each plant by itself.
Objects as_triangles(const World& world, Grown plants = Grown::left_out);

/// Fills in what depends on the terrain: positions given above the ground become positions above
/// the sea, the basket view gets its camera, and Scene::origin is chosen. Throws Error{bad_data} if
/// a place is beyond the 1000 km that a scene may ask for, or if that puts the camera's target at
/// its position.
void resolve(scene::Scene& scene);

/// The same on a surface that is already there.
void resolve(scene::Scene& scene, const Surface& surface);

/// Lifts the eye of a resolved scene, and what it looks at, to 2 m above the land's mesh of at most
/// `cells` a side where it would be lower: on another land than that which it was set up for, or on
/// a coarser mesh, it can be inside a mountain.
void unbury_eye(scene::Scene& scene, const Surface& surface, int cells);

}  // namespace aerostat::world
