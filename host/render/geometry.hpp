#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "pack/pack_geometry.hpp"
#include "pack/pack_scene.hpp"
#include "render/buffers.hpp"
#include "render/session.hpp"
#include "world/world.hpp"

namespace aerostat::render {

/// The world and its trees on the host. Groups that an edit of the scene leaves alone are shared
/// with the former state.
struct HostGeometry {
  explicit HostGeometry(world::World built) : world(std::move(built)) {}

  /// The world, without the shapes that were given up.
  world::World world;
  /// The packed groups of the world.
  std::vector<std::shared_ptr<const pack::PackedGroup>> groups;
  double world_seconds = 0.0, tree_seconds = 0.0;
  /// The numbers of groups that were not shared.
  int worlds_built = 0, trees_built = 0;
};

/// The arrays of groups, by the revision of the group. They exist once: whoever makes them moves
/// them on, until a FrameArrays takes them.
using GroupArrays = std::map<std::uint64_t, pack::PackedArrays>;

/// A geometry, which may be shared, and the arrays of those groups that were packed for it.
struct BuiltGeometry {
  std::shared_ptr<const HostGeometry> geometry;
  GroupArrays arrays;
};

/// Tells whether the meshes stay when the trees are built, for callers that look at them.
enum class Meshes { keep, release };

struct GeometryOptions {
  Meshes meshes = Meshes::keep;
  /// If plants stay as they stand, the geometry is that of the scene seen by the camera of the
  /// previous scene.
  Plants plants = Plants::as_seen;
  scatter::Where where = scatter::Where::everywhere;
  world::Carving carving = world::Carving::fine;
  world::GroupKinds kinds = world::all_kinds();
  /// The cache of reliefs. Null means that the land is carved for this geometry alone.
  world::ReliefCache* reliefs = nullptr;
  /// The cache of models from files. Null means that they are read for this geometry alone.
  world::ModelCache* models = nullptr;
};

/// Builds the geometry of a scene. Groups that `previous` (may be null) has already are
/// kept. Throws Error{exhausted} if memory does not suffice.
BuiltGeometry build_geometry(const scene::ResolvedScene& scene, const HostGeometry* previous,
                             const GeometryOptions& options = {});

/// Packs a world, which took so many seconds to build. Groups that `previous` (may be null) has
/// already are kept. Throws as build_geometry does.
BuiltGeometry pack_world(world::World world, const HostGeometry* previous, Meshes meshes,
                         double world_seconds = 0.0);

/// Adds the maps of shadows in the air to a packed scene, by the ground of a geometry.
void add_air_shadows(const HostGeometry& geometry, const scene::ResolvedScene& scene,
                     pack::ShadowCache& cache, pack::PackedScene& packed);

/// Returns whether a world has the group of a revision.
bool has_group(const world::World& world, std::uint64_t revision);

/// Returns whether two geometries have the same groups.
bool same_groups(const HostGeometry& a, const HostGeometry& b);

/// The triangles, vertices and instances of a frame and the ground: those of all groups, one behind
/// the other. The arrays of a group are moved or copied here and stay as long as the group does.
class FrameArrays {
 public:
  /// Makes the arrays those of `geometry`, whose common tree is `tree`. Groups that are not here
  /// already must be in `fresh`. Throws Error{exhausted}; all arrays are lost then.
  void assemble(const HostGeometry& geometry, const bvh::JoinedBvh& tree, GroupArrays fresh);

  const pack::PackedArrays& arrays() const { return arrays_; }
  const std::vector<AeroInstance>& instances() const { return instances_; }
  /// The height grid that the kernels read, or null.
  const std::shared_ptr<const mesh::GridMesh>& ground() const { return ground_; }

 private:
  /// The part of the arrays that belongs to a group.
  struct Section {
    std::uint64_t revision = 0;
    pack::Room room;
  };

  void assemble_arrays(const HostGeometry& geometry, GroupArrays fresh);
  std::size_t count_kept(const HostGeometry& geometry) const;
  void cut_from(std::size_t first, const HostGeometry& geometry, GroupArrays& arrays);
  void add(const Section& section, GroupArrays& fresh, const pack::Room& whole);

  std::shared_ptr<const mesh::GridMesh> ground_;
  std::vector<Section> sections_;
  pack::PackedArrays arrays_;
  std::vector<AeroInstance> instances_;
};

/// The common tree of a frame.
std::shared_ptr<const bvh::JoinedBvh> join_trees(const HostGeometry& geometry);

/// The tree and the arrays of a frame.
struct Frame {
  std::shared_ptr<const bvh::JoinedBvh> tree;
  std::shared_ptr<const FrameArrays> arrays;
};

/// The frame of a geometry that is shown once.
Frame only_frame(BuiltGeometry built);

/// A frame's geometry on the device; a CPU reads it where it is.
struct DeviceGeometry {
  NodeBuffer nodes;
  TriangleBuffer triangles;
  FaceBuffer faces;
  VertexBuffer vertices;
  InstanceBuffer instances;
  GridBuffer grid;
  bvh::BuildStats tree;

  std::uint64_t triangle_count() const;
  std::uint64_t bytes() const;
};

/// Gives geometry to the device. The arrays may change again when the result is gone. `between` is
/// called from time to time and may give up by throwing.
DeviceGeometry upload(const opencl::Context& context, const opencl::MemoryBudget& budget,
                      const std::shared_ptr<const bvh::Bvh>& tree,
                      const std::shared_ptr<const FrameArrays>& frame,
                      const std::function<void()>& between = {});

}  // namespace aerostat::render
