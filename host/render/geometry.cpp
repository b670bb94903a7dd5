#include "render/geometry.hpp"

#include <new>

#include "core/error.hpp"
#include "core/stopwatch.hpp"

namespace aerostat::render {
namespace {

using GroupPointer = std::shared_ptr<const pack::PackedGroup>;

/// The tree of a group, or the one it had before.
GroupPointer pack(const world::Group& group, const world::Group& old_group,
                  const GroupPointer& old_tree, HostGeometry& geometry) {
  if (!group) return nullptr;
  if (group == old_group && old_tree) return old_tree;
  ++geometry.trees_built;
  return std::make_shared<const pack::PackedGroup>(pack::pack_group(*group));
}

}  // namespace

std::shared_ptr<const HostGeometry> build_geometry(const scene::Scene& scene,
                                                   const HostGeometry* previous) {
  static const HostGeometry kNothing;
  const HostGeometry& old = previous != nullptr ? *previous : kNothing;
  auto geometry = std::make_shared<HostGeometry>();
  geometry->scene = scene;
  Stopwatch watch;
  try {
    geometry->world = world::build(scene, previous != nullptr ? &old.world : nullptr,
                                   previous != nullptr ? &old.scene : nullptr);
    const auto& world = geometry->world;
    geometry->worlds_built = (world.land != old.world.land ? 1 : 0) +
                             (world.balloon && world.balloon != old.world.balloon ? 1 : 0);
    geometry->world_seconds = watch.restart();
    geometry->land = pack(world.land, old.world.land, old.land, *geometry);
    geometry->balloon = pack(world.balloon, old.world.balloon, old.balloon, *geometry);
    geometry->tree_seconds = watch.seconds();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::exhausted,
                "not enough memory to build the world; a smaller /terrain/cells needs less");
  }
  return geometry;
}

std::uint64_t DeviceGeometry::bytes() const {
  return nodes.bytes() + triangles.bytes() + faces.bytes() + vertices.bytes();
}

pack::PackedGeometry join(const HostGeometry& geometry) {
  try {
    return pack::join_groups({geometry.land.get(), geometry.balloon.get()});
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::exhausted,
                "not enough memory to upload the world; a smaller /terrain/cells needs less");
  }
}

DeviceGeometry upload(const opencl::Context& context, const opencl::MemoryBudget& budget,
                      const pack::PackedGeometry& all, const std::function<void()>& between) {
  const auto pause = [&between] {
    if (between) between();
  };
  DeviceGeometry device;
  device.tree = all.tree;
  device.nodes = {context, budget, std::span(all.nodes), "the tree"};
  pause();
  device.triangles = {context, budget, std::span(all.triangles), "the triangles"};
  pause();
  device.faces = {context, budget, std::span(all.faces), "the triangles' indices"};
  pause();
  device.vertices = {context, budget, std::span(all.vertices), "the vertices"};
  pause();
  return device;
}

DeviceGeometry upload(const opencl::Context& context, const opencl::MemoryBudget& budget,
                      const HostGeometry& geometry) {
  return upload(context, budget, join(geometry));
}

}  // namespace aerostat::render
