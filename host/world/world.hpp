#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "scatter/scatter.hpp"
#include "scene/resolved_scene.hpp"
#include "world/group.hpp"
#include "world/kinds.hpp"
#include "world/scene_models.hpp"
#include "world/surface.hpp"

/// Builds the triangles of a scene, which are rendered and exported.
namespace aerostat::world {

/// The groups of objects that a scene shows. Positions count from the origin of the scene.
struct World {
  /// The scene that the world was built for.
  scene::ResolvedScene scene;
  /// One group of each kind, in the order of the kinds.
  std::vector<Group> groups;
  /// The models from files that the scene places.
  std::shared_ptr<const SceneModels> models = nullptr;
};

/// Returns the shape of a group, or null if the world has no group of the kind, its shape was given
/// up or it is another kind of shape.
template <typename T>
const T* shape_of(const World& world, const GroupKind& kind) {
  for (const Group& group : world.groups) {
    if (group.kind == &kind && group.shape) return std::get_if<T>(group.shape.get());
  }
  return nullptr;
}

struct BuildOptions {
  /// Tells where plants are placed.
  scatter::Where where = scatter::Where::everywhere;
  /// The detail of the land.
  Carving carving = Carving::fine;
  GroupKinds kinds = all_kinds();
  /// The cache of reliefs. Null means that the land is carved for this build alone.
  ReliefCache* reliefs = nullptr;
  /// The cache of models from files. Null means that they are read for this build alone.
  ModelCache* models = nullptr;
  /// A world of which groups are kept if they are what the scene asks for and were built with the
  /// same options.
  const World* previous = nullptr;
};

/// Builds the world of a scene. It runs on all cores and may be given up
/// (core/stop_scope.hpp). Throws Error{exhausted} if memory does not suffice, and the errors of
/// ModelCache::models_of().
World build(const scene::ResolvedScene& scene, const BuildOptions& options = {});

/// Says whether instances are among what is written out as triangles.
enum class Placed { left_out, included };

/// Returns the number of triangles that as_triangles() would write out.
std::uint64_t count_triangles(const World& world, Placed instances = Placed::left_out);

/// Returns the world as triangles, group by group. Instances, if asked for, are written out one by
/// one, into one mesh for each object and material. Groups whose shape was given up are left out.
Objects as_triangles(const World& world, Placed instances = Placed::left_out);

}  // namespace aerostat::world
