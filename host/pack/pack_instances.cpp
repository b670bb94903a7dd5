#include "pack/pack_instances.hpp"

#include <oneapi/tbb/parallel_for.h>

#include "bvh/instances.hpp"
#include "core/copy.hpp"

namespace aerostat::pack {
namespace {

AeroInstance pack_instance(const scatter::Instance& instance, const scatter::Axes& axes,
                           bool is_plant) {
  AeroInstance packed{};
  copy(packed.axes[0], axes.x);
  copy(packed.axes[1], axes.y);
  copy(packed.axes[2], axes.z);
  copy(packed.position, instance.position);
  packed.scale = instance.scale;
  copy(packed.tint, instance.tint);
  packed.root = instance.model;
  packed.is_plant = is_plant ? 1u : 0u;
  return packed;
}

/// Bounds of a model's box where an instance stands.
bvh::Bounds placed(const bvh::Bounds& model, const scatter::Instance& instance,
                   const scatter::Axes& axes) {
  const vec3 centre = 0.5f * (model.lo + model.hi), half = 0.5f * (model.hi - model.lo);
  const vec3 at = instance.position + axes.x * centre.x + axes.y * centre.y + axes.z * centre.z;
  const vec3 reach =
      glm::abs(axes.x) * half.x + glm::abs(axes.y) * half.y + glm::abs(axes.z) * half.z;
  // The box is widened by what the kernels' turning into the model rounds, with room to spare.
  const vec3 room = 4e-6f * (glm::abs(at) + reach) + 1e-4f;
  return {at - reach - room, at + reach + room};
}

/// Packs each model by itself and puts their arrays one behind the other.
void pack_models(const std::vector<world::InstanceModel>& models, const Room& more,
                 Packed& packed) {
  std::vector<Packed> parts(models.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    parts[i] = pack_objects(*models[i].parts, {}, models[i].first_file_material);
  });
  Room room = more;
  for (const Packed& part : parts) room += part.group.room;
  reserve(packed.arrays, room);
  for (Packed& part : parts) {
    append(packed.arrays, part.arrays);
    packed.group.models.push_back(std::move(part.group.trees.front()));
  }
}

}  // namespace

Packed pack_instances(const world::Instances& instances, const Room& more) {
  Packed packed;
  const std::size_t count = instances.places.size();
  if (count == 0) return packed;
  pack_models(instances.models, more, packed);
  PackedGroup& group = packed.group;
  group.room = room_of(packed.arrays);
  group.instances.resize(count);
  std::vector<bvh::Bounds> bounds(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const scatter::Instance& instance = instances.places[i];
    const scatter::Axes axes = scatter::axes_of(instance);
    group.instances[i] = pack_instance(instance, axes, instances.are_plants);
    bounds[i] = placed(group.models[instance.model].bounds, instance, axes);
    copy(group.instances[i].lo, bounds[i].lo);
    copy(group.instances[i].hi, bounds[i].hi);
  });
  group.trees.push_back(bvh::build_instances(bounds));
  return packed;
}

}  // namespace aerostat::pack
