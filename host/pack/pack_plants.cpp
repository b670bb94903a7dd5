#include "pack/pack_plants.hpp"

#include <oneapi/tbb/parallel_for.h>

#include "bvh/instances.hpp"
#include "pack/copy.hpp"

namespace aerostat::pack {
namespace {

AeroInstance pack_instance(const scatter::Instance& instance, const scatter::Axes& axes) {
  AeroInstance packed{};
  copy(packed.axes[0], axes.x);
  copy(packed.axes[1], axes.y);
  copy(packed.axes[2], axes.z);
  copy(packed.position, instance.position);
  packed.scale = instance.scale;
  copy(packed.tint, instance.tint);
  packed.root = instance.model;
  return packed;
}

/// Bounds of a model's box where an instance stands.
bvh::Bounds placed(const bvh::Bounds& model, const scatter::Instance& instance,
                   const scatter::Axes& axes) {
  const vec3 centre = 0.5f * (model.lo + model.hi), half = 0.5f * (model.hi - model.lo);
  const vec3 at = instance.position + axes.x * centre.x + axes.y * centre.y + axes.z * centre.z;
  const vec3 reach =
      glm::abs(axes.x) * half.x + glm::abs(axes.y) * half.y + glm::abs(axes.z) * half.z;
  // What the kernels' turning into the model rounds, with room to spare.
  const vec3 room = 4e-6f * (glm::abs(at) + reach) + 1e-4f;
  return {at - reach - room, at + reach + room};
}

}  // namespace

PackedPlants pack_plants(const world::Plants& plants) {
  PackedPlants packed;
  std::vector<PackedGroup> groups(plants.models.size());
  tbb::parallel_for(std::size_t{0}, groups.size(),
                    [&](std::size_t i) { groups[i] = pack_objects({plants.models[i]}); });
  for (PackedGroup& group : groups) {
    append(packed.arrays, group.arrays);
    packed.models.push_back(std::move(group.trees.front()));
  }
  const std::size_t count = plants.instances.size();
  packed.instances.resize(count);
  std::vector<bvh::Bounds> bounds(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const scatter::Instance& instance = plants.instances[i];
    const scatter::Axes axes = scatter::axes_of(instance);
    packed.instances[i] = pack_instance(instance, axes);
    bounds[i] = placed(packed.models[instance.model].bounds, instance, axes);
    copy(packed.instances[i].lo, bounds[i].lo);
    copy(packed.instances[i].hi, bounds[i].hi);
  });
  packed.tree = bvh::build_instances(bounds);
  return packed;
}

}  // namespace aerostat::pack
