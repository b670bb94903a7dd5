#pragma once

#include <functional>
#include <memory>

#include "opencl/buffer.hpp"
#include "pack/pack_geometry.hpp"
#include "render/session.hpp"
#include "world/world.hpp"

namespace aerostat::render {

/// The world and its trees on the host; what an edit of the scene leaves alone is shared with the
/// former state.
struct HostGeometry {
  scene::Scene scene;  // that it was built for
  world::World world;
  std::shared_ptr<const pack::PackedGroup> land, balloon;
  double world_seconds = 0.0, tree_seconds = 0.0;
  int worlds_built = 0, trees_built = 0;  // groups that were not shared
};

/// Builds the geometry of a scene, keeping what `previous` (may be null) has already.
std::shared_ptr<const HostGeometry> build_geometry(const scene::Scene& scene,
                                                   const HostGeometry* previous);

/// The buffers of a frame, still on the host.
pack::PackedGeometry join(const HostGeometry& geometry);

/// The same on the device.
struct DeviceGeometry {
  opencl::Buffer<AeroBvhNode> nodes;
  opencl::Buffer<AeroTriangle> triangles;
  opencl::Buffer<AeroFace> faces;
  opencl::Buffer<AeroVertex> vertices;
  bvh::BuildStats tree;

  std::uint64_t bytes() const;
};

/// Copies geometry to the device. `between` is called from time to time and may give up by
/// throwing.
DeviceGeometry upload(const opencl::Context& context, const opencl::MemoryBudget& budget,
                      const pack::PackedGeometry& all, const std::function<void()>& between = {});

/// Both in one.
DeviceGeometry upload(const opencl::Context& context, const opencl::MemoryBudget& budget,
                      const HostGeometry& geometry);

}  // namespace aerostat::render
