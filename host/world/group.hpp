#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "mesh/grid_mesh.hpp"
#include "mesh/mesh.hpp"
#include "scatter/scatter.hpp"
#include "scene/objects.hpp"
#include "scene/resolved_scene.hpp"
#include "terrain/carving.hpp"
#include "terrain/relief_cache.hpp"

/// A world consists of groups, each of which is built, kept and thrown away as a whole.
namespace aerostat::world {

struct SceneModels;

/// A mesh with the object that it is and the material that it is made of.
struct Object {
  scene::ObjectId id = scene::ObjectId::terrain;
  scene::MaterialId material = scene::MaterialId::terrain;
  mesh::TriangleMesh mesh;
  /// The place in scene::balloons_of() of the balloon that it is a part of, or 0.
  std::size_t balloon = 0;
  /// The number of the material among those of a file, in place of `material`.
  std::optional<std::uint32_t> file_material = {};
};

using Objects = std::vector<Object>;

/// A surface of heights, which the kernels read as it is and take for the terrain. A world has at
/// most one.
struct HeightGrid {
  std::shared_ptr<const mesh::GridMesh> mesh;
};

/// A model that stands in the world many times.
struct InstanceModel {
  std::shared_ptr<const Objects> parts;
  /// The number, among those of all models of a scene, of the material that is the first one of the
  /// parts' file.
  std::uint32_t first_file_material = 0;
};

/// Returns a model of these parts, without materials of files.
InstanceModel instance_model(Objects parts);

/// Models and where they stand.
struct Instances {
  std::vector<InstanceModel> models;
  /// The instances. Their `model` is an index into `models`.
  std::vector<scatter::Instance> places;
  /// Whether they are plants and stones, of which exports may leave out all, and whose shade is
  /// known beforehand where they are small.
  bool are_plants = true;
};

/// The shapes that packing and exporting know. A group of nothing is an empty list of objects.
using Shape = std::variant<Objects, HeightGrid, Instances>;

/// Returns whether a shape has nothing to show.
bool is_empty(const Shape& shape);

/// The scene and the detail that groups are built for.
struct GroupRequest {
  const scene::ResolvedScene& scene;
  /// The models from files that the scene places.
  std::shared_ptr<const SceneModels> models;
  scatter::Where where = scatter::Where::everywhere;
  terrain::Carving carving = terrain::Carving::fine;
  /// The obstacles of all kinds of groups.
  std::vector<scatter::Obstacle> obstacles = {};
  /// The ground while groups that stand on it are compared and built, else null.
  const mesh::GridMesh* ground = nullptr;
};

/// The input from which a group is built.
struct GroupInput {
  const GroupRequest& request;
  /// The scene of the request. Its positions count from its origin.
  const scene::Scene& local;
  /// The ground for groups that stand on it, else null.
  const mesh::GridMesh* ground;
  terrain::ReliefCache& reliefs;
};

/// The relation of a group to the ground.
enum class Footing {
  ground,     // The group is the ground, a HeightGrid.
  on_ground,  // The group is built after the ground, and again whenever the ground is.
  none        // The group is built beside the ground.
};

/// A kind of group. To add one, write its file beside land.cpp and list it in kinds.cpp.
struct GroupKind {
  /// The name for messages.
  const char* name = "";
  Footing footing = Footing::none;
  /// Builds the group. Positions count from the scene's origin. Runs on all cores; throws
  /// Error{interrupted} if core/stop_scope.hpp asks to stop.
  Shape (*build)(const GroupInput& input) = nullptr;
  /// Returns whether a group that was built for `before` is also what `now` asks for. Both scenes
  /// have the same origin and, for a group on the ground, the same ground.
  bool (*same)(const GroupRequest& now, const GroupRequest& before) = nullptr;
  /// Returns where the objects stand that plants leave room for. The request has no obstacles yet.
  /// Null means that plants leave no room.
  std::vector<scatter::Obstacle> (*obstacles)(const GroupRequest& request) = nullptr;
};

/// A group of a world. Two groups of the same revision are the same; a build gives a revision that
/// nothing else in the process has.
struct Group {
  const GroupKind* kind = nullptr;
  std::uint64_t revision = 0;
  /// The shape, or null if it was given up to save memory.
  std::shared_ptr<const Shape> shape;
};

/// Makes a group with a new revision.
Group make_group(const GroupKind& kind, Shape shape);

}  // namespace aerostat::world
