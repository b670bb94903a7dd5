#include "render/geometry.hpp"

#include <algorithm>
#include <new>
#include <span>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "core/stopwatch.hpp"
#include "scene/local_frame.hpp"
#include "scene/scene.hpp"

namespace aerostat::render {
namespace {

/// Packs the groups of the world, or takes them from the former geometry.
class Packer {
 public:
  /// Makes a packer that knows the groups of `old`, which may be null.
  Packer(const HostGeometry* old, Meshes meshes) : old_(old), meshes_(meshes) {}

  /// Fills in the packed groups and returns the arrays of those that are new. Groups are packed
  /// from the last one to the first, each with room for those behind it: a frame then takes the
  /// first arrays over as they are and appends the others.
  GroupArrays run(HostGeometry& geometry) {
    const std::stop_token stop = current_stop();
    auto& groups = geometry.world.groups;
    geometry.groups.resize(groups.size());
    pack::Room behind;
    for (std::size_t i = groups.size(); i-- > 0;) {
      stop_if_asked(stop);
      geometry.groups[i] = known(groups[i].revision);
      if (!geometry.groups[i]) geometry.groups[i] = pack(groups[i], behind, geometry.trees_built);
      behind += geometry.groups[i]->room;
    }
    return std::move(arrays_);
  }

 private:
  std::shared_ptr<const pack::PackedGroup> known(std::uint64_t revision) const {
    for (std::size_t i = 0; old_ != nullptr && i < old_->groups.size(); ++i) {
      if (old_->world.groups[i].revision == revision) return old_->groups[i];
    }
    return nullptr;
  }

  std::shared_ptr<const pack::PackedGroup> pack(world::Group& group, const pack::Room& behind,
                                                int& trees_built) {
    pack::Packed packed = pack::pack_shape(*group.shape, behind);
    trees_built += packed.group.trees.empty() ? 0 : 1;
    arrays_.emplace(group.revision, std::move(packed.arrays));
    // The ground is read as it is, by kernels and by groups that are built on it.
    const bool is_grid = std::holds_alternative<world::HeightGrid>(*group.shape);
    if (meshes_ == Meshes::release && !is_grid) group.shape = nullptr;
    return std::make_shared<const pack::PackedGroup>(std::move(packed.group));
  }

  const HostGeometry* old_;
  Meshes meshes_;
  GroupArrays arrays_;
};

/// Returns the number of groups of a world that hold something and are not in the old one, which
/// may be null.
int count_built(const world::World& world, const HostGeometry* old) {
  return static_cast<int>(
      std::count_if(world.groups.begin(), world.groups.end(), [&](const world::Group& group) {
        const bool is_kept = old != nullptr && has_group(old->world, group.revision);
        return !is_kept && !world::is_empty(*group.shape);
      }));
}

[[noreturn]] void fail_to_upload() {
  throw Error(ErrorKind::exhausted,
              "not enough memory to upload the world; a smaller /terrain/cells needs less");
}

/// Returns a copy of `room` elements of arrays, which come after `before` others.
pack::PackedArrays copy_of(const pack::PackedArrays& arrays, const pack::Room& before,
                           const pack::Room& room) {
  const auto part = [](const auto& all, std::size_t first, std::size_t count) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    return std::decay_t<decltype(all)>(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  pack::PackedArrays copy{part(arrays.triangles, before.triangles, room.triangles),
                          part(arrays.faces, before.triangles, room.triangles),
                          part(arrays.vertices, before.vertices, room.vertices)};
  for (AeroFace& face : copy.faces) {
    for (auto& vertex : face.vertex) vertex -= static_cast<std::uint32_t>(before.vertices);
  }
  return copy;
}

}  // namespace

BuiltGeometry pack_world(world::World world, const HostGeometry* previous, Meshes meshes,
                         double world_seconds) {
  auto geometry = std::make_shared<HostGeometry>(std::move(world));
  geometry->world_seconds = world_seconds;
  geometry->worlds_built = count_built(geometry->world, previous);
  const Stopwatch watch;
  try {
    GroupArrays arrays = Packer(previous, meshes).run(*geometry);
    geometry->tree_seconds = watch.seconds();
    return {std::move(geometry), std::move(arrays)};
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::exhausted,
                "not enough memory to build the world; a smaller /terrain/cells needs less");
  }
}

BuiltGeometry build_geometry(const scene::ResolvedScene& scene, const HostGeometry* previous,
                             const GeometryOptions& options) {
  // Only plants and the detail of balloons depend on the eye.
  const bool keeps_eye = options.plants == Plants::as_they_stand && previous != nullptr;
  const scene::ResolvedScene seen = keeps_eye ? scene.seen_as(previous->world.scene) : scene;
  world::BuildOptions build;
  build.where = options.where;
  build.carving = options.carving;
  build.kinds = options.kinds;
  build.reliefs = options.reliefs;
  build.models = options.models;
  build.previous = previous != nullptr ? &previous->world : nullptr;
  const Stopwatch watch;
  world::World world = world::build(seen, build);
  return pack_world(std::move(world), previous, options.meshes, watch.seconds());
}

void add_air_shadows(const HostGeometry& geometry, const scene::ResolvedScene& scene,
                     pack::ShadowCache& cache, pack::PackedScene& packed) {
  const mesh::GridMesh* ground = nullptr;
  std::uint64_t revision = 0;
  for (std::size_t i = 0; i < geometry.groups.size(); ++i) {
    if (!geometry.groups[i]->grid) continue;
    ground = geometry.groups[i]->grid.get();
    revision = geometry.world.groups[i].revision;
  }
  pack::add_air_shadows(ground, revision, vec3(scene::place_of(*scene, scene.eye())), cache,
                        packed);
}

bool has_group(const world::World& world, std::uint64_t revision) {
  return std::any_of(world.groups.begin(), world.groups.end(),
                     [&](const world::Group& group) { return group.revision == revision; });
}

bool same_groups(const HostGeometry& a, const HostGeometry& b) {
  return std::equal(a.world.groups.begin(), a.world.groups.end(), b.world.groups.begin(),
                    b.world.groups.end(), [](const world::Group& one, const world::Group& other) {
                      return one.revision == other.revision;
                    });
}

void FrameArrays::assemble(const HostGeometry& geometry, const bvh::JoinedBvh& tree,
                           GroupArrays fresh) {
  try {
    assemble_arrays(geometry, std::move(fresh));
    instances_ = pack::join_instances(geometry.groups, tree);
  } catch (const std::bad_alloc&) {
    *this = {};
    fail_to_upload();
  }
  ground_ = nullptr;
  for (const auto& group : geometry.groups) {
    if (group->grid) ground_ = group->grid;
  }
}

/// Leaves the first groups where they are as long as they are the same as before. The arrays behind
/// them are put together again from arrays that were here and fresh ones.
void FrameArrays::assemble_arrays(const HostGeometry& geometry, GroupArrays fresh) {
  const std::size_t kept = count_kept(geometry);
  cut_from(kept, geometry, fresh);
  pack::Room whole;
  for (const auto& group : geometry.groups) whole += group->room;
  for (std::size_t i = kept; i < geometry.groups.size(); ++i) {
    add({geometry.world.groups[i].revision, geometry.groups[i]->room}, fresh, whole);
  }
}

std::size_t FrameArrays::count_kept(const HostGeometry& geometry) const {
  const auto& groups = geometry.world.groups;
  std::size_t kept = 0;
  while (kept < sections_.size() && kept < groups.size() &&
         sections_[kept].revision == groups[kept].revision) {
    ++kept;
  }
  return kept;
}

/// Drops the sections from `first` on. Sections that the geometry still has are copied to `arrays`.
void FrameArrays::cut_from(std::size_t first, const HostGeometry& geometry, GroupArrays& arrays) {
  pack::Room before, end;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const Section& section = sections_[i];
    if (i >= first && has_group(geometry.world, section.revision)) {
      arrays[section.revision] = copy_of(arrays_, before, section.room);
    }
    before += section.room;
    if (i < first) end = before;
  }
  sections_.resize(first);
  arrays_.triangles.resize(end.triangles);
  arrays_.faces.resize(end.triangles);
  arrays_.vertices.resize(end.vertices);
}

/// Moves the arrays of a group from `fresh` to the end. `whole` is the room of all groups together.
void FrameArrays::add(const Section& section, GroupArrays& fresh, const pack::Room& whole) {
  const auto found = fresh.find(section.revision);
  if (found == fresh.end()) {
    throw Error(ErrorKind::internal,
                fmt::format("the arrays of revision {} are nowhere", section.revision));
  }
  if (arrays_.triangles.empty() && arrays_.vertices.empty()) {
    arrays_ = std::move(found->second);
  } else {
    pack::reserve(arrays_, whole);
    pack::append(arrays_, found->second);
  }
  fresh.erase(found);
  sections_.push_back(section);
}

std::shared_ptr<const bvh::JoinedBvh> join_trees(const HostGeometry& geometry) {
  try {
    return std::make_shared<const bvh::JoinedBvh>(pack::join_trees(geometry.groups));
  } catch (const std::bad_alloc&) {
    fail_to_upload();
  }
}

Frame only_frame(BuiltGeometry built) {
  const auto tree = join_trees(*built.geometry);
  const auto arrays = std::make_shared<FrameArrays>();
  arrays->assemble(*built.geometry, *tree, std::move(built.arrays));
  return {tree, arrays};
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
  const auto& ground = frame->ground();
  give(device.grid, ground ? ground->words() : std::span<const float>(), ground, "the ground");
  return device;
}

}  // namespace aerostat::render
