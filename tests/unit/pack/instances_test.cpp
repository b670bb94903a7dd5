// Tests the boxes of instances, which the tree over them is built from.
#include <gtest/gtest.h>

#include "pack/pack_instances.hpp"

namespace aerostat {
namespace {

/// Returns a model that lies to one side of its origin on all axes.
world::Object model_aside() {
  mesh::TriangleMesh mesh;
  mesh.positions = {{2, 1, 5}, {4, 1, 5}, {2, 3, 8}};
  mesh.normals.assign(3, vec3(0, 1, 0));
  mesh.colors.assign(3, vec3(1.0f));
  mesh.triangles = {{0, 1, 2}};
  return {scene::ObjectId::plant, scene::MaterialId::plant, std::move(mesh)};
}

TEST(PackedInstances, BoxesHoldTheirModels) {
  world::Instances instances;
  instances.models.push_back(world::instance_model({model_aside()}));
  for (int i = 0; i < 16; ++i) {
    scatter::Instance instance;
    instance.position = {100.0f * static_cast<float>(i), 7.0f, -40.0f};
    instance.yaw_rad = 0.4f * static_cast<float>(i);
    instance.lean = {0.2f, -0.1f};
    instance.scale = 1.5f;
    instances.places.push_back(instance);
  }
  const pack::Packed packed = pack::pack_instances(instances, {});
  ASSERT_EQ(packed.group.instances.size(), instances.places.size());
  for (std::size_t i = 0; i < instances.places.size(); ++i) {
    const scatter::Instance& instance = instances.places[i];
    const scatter::Axes axes = scatter::axes_of(instance);
    const AeroInstance& found = packed.group.instances[i];
    float volume = 1.0f;
    for (int axis = 0; axis < 3; ++axis) volume *= found.hi[axis] - found.lo[axis];
    EXPECT_LT(volume, 500.0f) << "the model's box is 2 x 2 x 3 m and 1.5 times as large";
    for (const vec3& v : model_aside().mesh.positions) {
      const vec3 p = instance.position + axes.x * v.x + axes.y * v.y + axes.z * v.z;
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(p[axis], found.lo[axis]) << i << ", axis " << axis;
        EXPECT_LE(p[axis], found.hi[axis]) << i << ", axis " << axis;
      }
    }
  }
}

}  // namespace
}  // namespace aerostat
