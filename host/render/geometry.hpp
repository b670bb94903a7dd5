#pragma once

#include <functional>
#include <memory>

#include "opencl/buffer.hpp"
#include "pack/pack_geometry.hpp"
#include "pack/pack_plants.hpp"
#include "render/session.hpp"
#include "world/world.hpp"

namespace aerostat::render {

/// The world and its trees on the host; what an edit of the scene leaves alone is shared with the
/// former state.
struct HostGeometry {
  scene::Scene scene;                       // that it was built for
  world::World world;                       // without objects where meshes were not kept
  std::shared_ptr<pack::PackedGroup> land;  // its arrays go into the FrameArrays
  std::shared_ptr<const pack::PackedGroup> balloon;
  std::shared_ptr<const pack::PackedPlants> plants;
  double world_seconds = 0.0, tree_seconds = 0.0;
  int worlds_built = 0, trees_built = 0;  // groups that were not shared
};

/// Whether the meshes stay when the trees are built, for who wants to look at them.
enum class Meshes { keep, release };

/// Builds the geometry of a scene, keeping what `previous` (may be null) has already. Where plants
/// stay as they stand, it is that of the scene seen by the previous one's camera.
std::shared_ptr<const HostGeometry> build_geometry(
    const scene::Scene& scene, const HostGeometry* previous, Meshes meshes = Meshes::keep,
    Plants plants = Plants::as_seen, scatter::Where where = scatter::Where::everywhere,
    world::Carving carving = world::Carving::fine);

/// The ground of a frame, and its triangles and vertices: the land's, taken out of its group rather
/// than copied, and behind them a copy of the balloon's and of the plants' models.
class FrameArrays {
 public:
  /// Makes them those of `geometry`, whose common tree is `tree`; the land stays if it is the one
  /// that is there. Throws Error{exhausted}.
  void assemble(const HostGeometry& geometry, const bvh::JoinedBvh& tree);

  const pack::PackedArrays& arrays() const { return arrays_; }
  const std::vector<AeroInstance>& instances() const { return instances_; }
  const std::shared_ptr<const mesh::GridMesh>& ground() const { return ground_; }

 private:
  std::shared_ptr<const mesh::GridMesh> ground_;
  pack::PackedArrays arrays_;
  std::vector<AeroInstance> instances_;
  std::shared_ptr<const pack::PackedGroup> land_;
  std::size_t land_triangles_ = 0, land_vertices_ = 0;
};

/// The common tree of a frame.
std::shared_ptr<const bvh::JoinedBvh> join_trees(const HostGeometry& geometry);

/// A frame's geometry on the device; a CPU reads it where it is.
struct DeviceGeometry {
  opencl::Buffer<AeroBvhNode> nodes;
  opencl::Buffer<AeroTriangle> triangles;
  opencl::Buffer<AeroFace> faces;
  opencl::Buffer<AeroVertex> vertices;
  opencl::Buffer<AeroInstance> instances;
  opencl::Buffer<float> grid;  // the ground
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

/// All in one, for the only frame of `geometry`.
DeviceGeometry upload(const opencl::Context& context, const opencl::MemoryBudget& budget,
                      const HostGeometry& geometry);

}  // namespace aerostat::render
