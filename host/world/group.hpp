#pragma once

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "mesh/grid_mesh.hpp"
#include "mesh/mesh.hpp"
#include "scatter/scatter.hpp"
#include "scene/scene.hpp"
#include "terrain/carving.hpp"
#include "terrain/relief_cache.hpp"

/// What a world is made of: groups, each of which is built, kept and thrown away as a whole.
namespace aerostat::world {

/// A mesh, what it is and what it is made of.
struct Object {
  scene::ObjectId id = scene::ObjectId::terrain;
  scene::MaterialId material = scene::MaterialId::terrain;
  mesh::TriangleMesh mesh;
};

using Objects = std::vector<Object>;

/// A surface of heights, which the kernels read as it is and take for the terrain. A world has at
/// most one.
struct HeightGrid {
  std::shared_ptr<const mesh::GridMesh> mesh;
};

/// Models that stand in the world many times.
struct Instances {
  Objects models;
  std::vector<scatter::Instance> places;  // `model` counts in `models`
};

/// The shapes that packing and exporting know. A group of nothing is an empty list of objects.
using Shape = std::variant<Objects, HeightGrid, Instances>;

/// Returns whether a shape has nothing to show.
bool is_empty(const Shape& shape);

/// What a group is built for.
struct GroupRequest {
  const scene::Scene& scene;  // resolved
  scatter::Where where = scatter::Where::everywhere;
  terrain::Carving carving = terrain::Carving::fine;
  std::vector<scatter::Obstacle> obstacles = {};  // of all kinds
};

/// What a group is built from.
struct GroupInput {
  const GroupRequest& request;
  const scene::Scene& local;     // the request's scene, counted from its origin
  const mesh::GridMesh* ground;  // for groups on the ground, else null
  terrain::ReliefCache& reliefs;
};

/// What a group has to do with the ground.
enum class Footing {
  ground,     // it is the ground, a HeightGrid
  on_ground,  // it is built after the ground, and anew whenever the ground is
  none        // it is built beside the ground
};

/// A kind of group. To add one, write its file beside land.cpp and list it in kinds.cpp.
struct GroupKind {
  const char* name = "";  // for messages
  Footing footing = Footing::none;
  /// Builds the group. Positions count from Scene::origin. Runs on all cores; throws
  /// Error{interrupted} if core/stop_scope.hpp asks to stop.
  Shape (*build)(const GroupInput& input) = nullptr;
  /// Returns whether a group that was built for `before` is also what `now` asks for. Both scenes
  /// have the same origin and, for a group on the ground, the same ground.
  bool (*same)(const GroupRequest& now, const GroupRequest& before) = nullptr;
  /// Returns where the objects stand that plants leave room for. Null means that they leave none.
  std::vector<scatter::Obstacle> (*obstacles)(const scene::Scene& scene) = nullptr;
};

/// A group of a world. Two groups of the same revision are the same; a build gives a revision that
/// nothing else in the process has.
struct Group {
  const GroupKind* kind = nullptr;
  std::uint64_t revision = 0;
  std::shared_ptr<const Shape> shape;  // null: given up, to save memory
};

/// Makes a group with a new revision.
Group make_group(const GroupKind& kind, Shape shape);

}  // namespace aerostat::world
