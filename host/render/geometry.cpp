#include "render/geometry.hpp"

#include <algorithm>
#include <new>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "core/stopwatch.hpp"

namespace aerostat::render {
namespace {

/// Packs the parts of the world, or takes them from the former geometry.
class Packer {
 public:
  Packer(const HostGeometry& old, Meshes meshes, HostGeometry& geometry)
      : old_(old), meshes_(meshes), geometry_(geometry) {}

  void run() {
    const std::stop_token stop = current_stop();
    stop_if_asked(stop);
    pack_balloon();
    stop_if_asked(stop);
    pack_plants();
    stop_if_asked(stop);
    pack_land();
  }

 private:
  void pack_balloon() {
    auto& balloon = geometry_.world.balloon;
    if (!balloon) return;
    if (balloon == old_.world.balloon && old_.balloon) {
      geometry_.balloon = old_.balloon;
      return;
    }
    ++geometry_.trees_built;
    geometry_.balloon = std::make_shared<pack::PackedGroup>(pack::pack_objects(*balloon));
    // The meshes gone, the identity left.
    if (meshes_ == Meshes::release) balloon = std::make_shared<const world::Objects>();
  }

  void pack_plants() {
    const auto& plants = geometry_.world.plants;
    if (!plants) return;
    if (plants == old_.world.plants && old_.plants) {
      geometry_.plants = old_.plants;
      return;
    }
    ++geometry_.trees_built;
    geometry_.plants = std::make_shared<pack::PackedPlants>(pack::pack_plants(*plants));
  }

  void pack_land() {
    auto& land = geometry_.world.land;
    if (land == old_.world.land && old_.land) {
      geometry_.land = old_.land;
      return;
    }
    ++geometry_.trees_built;
    const pack::Room room = room_of(geometry_.balloon.get()) + room_of(geometry_.plants.get());
    geometry_.land = std::make_shared<pack::PackedGroup>(pack::pack_land(*land, room));
    if (meshes_ == Meshes::release)
      land = std::make_shared<const world::Land>(world::Land{land->ground, {}});
  }

  template <typename Packed>
  static pack::Room room_of(const Packed* packed) {
    if (packed == nullptr) return {};
    return {packed->arrays.triangles.size(), packed->arrays.vertices.size()};
  }

  const HostGeometry& old_;
  Meshes meshes_;
  HostGeometry& geometry_;
};

[[noreturn]] void fail_to_upload() {
  throw Error(ErrorKind::exhausted,
              "not enough memory to upload the world; a smaller /terrain/cells needs less");
}

/// The arrays of a group, which are there once.
pack::PackedArrays taken(pack::PackedGroup& group) {
  const bool has_slots = std::any_of(group.trees.begin(), group.trees.end(),
                                     [](const bvh::Bvh& tree) { return tree.slots > 0; });
  if (group.arrays.vertices.empty() && has_slots) {
    throw Error(ErrorKind::internal, "the land's arrays were given to a frame before");
  }
  return std::move(group.arrays);
}

}  // namespace

std::shared_ptr<const HostGeometry> build_geometry(const scene::Scene& scene,
                                                   const HostGeometry* previous, Meshes meshes,
                                                   Plants plants, scatter::Where where,
                                                   world::Carving carving) {
  static const HostGeometry kNothing;
  const HostGeometry& old = previous != nullptr ? *previous : kNothing;
  auto geometry = std::make_shared<HostGeometry>();
  geometry->scene = scene;
  if (plants == Plants::as_they_stand && previous != nullptr) {
    // Nothing but plants and the balloon's detail goes by the eye.
    geometry->scene.camera = old.scene.camera;
    geometry->scene.image = old.scene.image;
  }
  Stopwatch watch;
  try {
    geometry->world = world::build(geometry->scene, previous != nullptr ? &old.world : nullptr,
                                   previous != nullptr ? &old.scene : nullptr, where, carving);
    const auto& world = geometry->world;
    geometry->worlds_built = (world.land != old.world.land ? 1 : 0) +
                             (world.balloon && world.balloon != old.world.balloon ? 1 : 0) +
                             (world.plants && world.plants != old.world.plants ? 1 : 0);
    geometry->world_seconds = watch.restart();
    Packer(old, meshes, *geometry).run();
    geometry->tree_seconds = watch.seconds();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::exhausted,
                "not enough memory to build the world; a smaller /terrain/cells needs less");
  }
  return geometry;
}

void FrameArrays::assemble(const HostGeometry& geometry, const bvh::JoinedBvh& tree) {
  if (land_ != geometry.land || !land_) {
    arrays_ = {};
    if (geometry.land) arrays_ = taken(*geometry.land);
    land_ = geometry.land;
    ground_ = geometry.world.land->ground;
    land_triangles_ = arrays_.triangles.size();
    land_vertices_ = arrays_.vertices.size();
  }
  arrays_.triangles.resize(land_triangles_);
  arrays_.faces.resize(land_triangles_);
  arrays_.vertices.resize(land_vertices_);
  try {
    if (geometry.balloon) pack::append(arrays_, geometry.balloon->arrays);
    instances_.clear();
    if (geometry.plants) {
      pack::append(arrays_, geometry.plants->arrays);
      instances_ = geometry.plants->instances;
      for (AeroInstance& instance : instances_) instance.root = tree.model_roots[instance.root];
    }
  } catch (const std::bad_alloc&) {
    fail_to_upload();
  }
}

std::shared_ptr<const bvh::JoinedBvh> join_trees(const HostGeometry& geometry) {
  try {
    return std::make_shared<const bvh::JoinedBvh>(
        pack::join_trees({geometry.land.get(), geometry.balloon.get()}, geometry.plants.get()));
  } catch (const std::bad_alloc&) {
    fail_to_upload();
  }
}

std::uint64_t DeviceGeometry::bytes() const {
  return nodes.bytes() + triangles.bytes() + faces.bytes() + vertices.bytes() + instances.bytes() +
         grid.bytes();
}

std::uint64_t DeviceGeometry::triangle_count() const {
  return tree.input_triangles - tree.dropped_non_finite - tree.dropped_degenerate;
}

DeviceGeometry upload(const opencl::Context& context, const opencl::MemoryBudget& budget,
                      const std::shared_ptr<const bvh::Bvh>& tree,
                      const std::shared_ptr<const FrameArrays>& frame,
                      const std::function<void()>& between) {
  const bool in_place = context.device().type == opencl::DeviceType::cpu;
  const auto give = [&](auto& buffer, auto values, const std::shared_ptr<const void>& owner,
                        const char* what) {
    if (in_place && !values.empty()) {
      buffer = {context, budget, owner, values, what};
    } else {
      buffer = {context, budget, values, what};
    }
    if (between) between();
  };
  const pack::PackedArrays& arrays = frame->arrays();
  DeviceGeometry device;
  device.tree = tree->stats;
  give(device.nodes, std::span(tree->nodes), tree, "the tree");
  give(device.triangles, std::span(arrays.triangles), frame, "the triangles");
  give(device.faces, std::span(arrays.faces), frame, "the triangles' indices");
  give(device.vertices, std::span(arrays.vertices), frame, "the vertices");
  give(device.instances, std::span(frame->instances()), frame, "the plants");
  give(device.grid, frame->ground()->words(), frame->ground(), "the ground");
  return device;
}

DeviceGeometry upload(const opencl::Context& context, const opencl::MemoryBudget& budget,
                      const HostGeometry& geometry) {
  const auto frame = std::make_shared<FrameArrays>();
  const auto tree = join_trees(geometry);
  frame->assemble(geometry, *tree);
  return upload(context, budget, tree, frame);
}

}  // namespace aerostat::render
