// Tests envelopes whose shape is a model from a file.
#include "world/special_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "model/envelope_shape.hpp"
#include "model/rigging.hpp"

namespace aerostat::world {
namespace {

/// A pyramid of 8 x 4 m that is 6 m high. The colours of its vertices are red below and green
/// above.
FileModel pyramid() {
  asset::Primitive primitive;
  primitive.positions = {{0, 0, 0}, {8, 0, 0}, {8, 0, 4}, {0, 0, 4}, {4, 6, 2}};
  primitive.colors.assign(4, {1, 0, 0, 1});
  primitive.colors.emplace_back(0, 1, 0, 1);
  primitive.triangles = {{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
  asset::Model model;
  model.materials.resize(1);
  model.materials[0].base_color = {0.5f, 0.5f, 0.5f, 1.0f};
  model.meshes.push_back({"pyramid", {primitive}});
  model.placements.push_back({});
  return file_model({"pyramid.obj", {}}, std::move(model));
}

TEST(SpecialEnvelope, StandsAboveTheMouth) {
  scene::Balloon balloon;
  balloon.position = {100.0, 50.0, -20.0};
  balloon.envelope = scene::EnvelopeModel{"pyramid.obj", scene::UpAxis::y, 18.0, 0.0};
  const mesh::TriangleMesh cloth = special_envelope(balloon, pyramid());
  ASSERT_EQ(cloth.triangles.size(), 4u);
  vec3 least(1e9f), most(-1e9f);
  for (const vec3& position : cloth.positions) {
    least = glm::min(least, position);
    most = glm::max(most, position);
  }
  const double mouth = 50.0 + model::mouth_height(balloon.diameter_m);
  EXPECT_LT(least.y, mouth) << "the skirt ends within it";
  EXPECT_GT(least.y, mouth - 1.0);
  EXPECT_NEAR(most.y - least.y, 18.0, 1e-4);
  EXPECT_NEAR(least.x, 100.0 - 12.0, 1e-4);
  EXPECT_NEAR(most.x, 100.0 + 12.0, 1e-4);
  EXPECT_NEAR(0.5 * (least.z + most.z), -20.0, 1e-4);
  for (const vec3& normal : cloth.normals) EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f);
}

TEST(SpecialEnvelope, IsAsHighAsAUsualOneAndTurns) {
  scene::Balloon balloon;
  balloon.envelope = scene::EnvelopeModel{"pyramid.obj", scene::UpAxis::y, {}, 60.0};
  balloon.heading_deg = 30.0;
  const mesh::TriangleMesh cloth = special_envelope(balloon, pyramid());
  float wide = 0.0f, deep = 0.0f, low = 1e9f, high = -1e9f;
  for (const vec3& position : cloth.positions) {
    wide = std::max(wide, std::abs(position.x));
    deep = std::max(deep, std::abs(position.z));
    low = std::min(low, position.y);
    high = std::max(high, position.y);
  }
  const model::EnvelopeShape usual(balloon.diameter_m, balloon.gores);
  EXPECT_NEAR(high - low, usual.height(), 1e-3);
  EXPECT_NEAR(deep, 2.0 * wide, 1e-3) << "its long side points to the south now";
}

TEST(SpecialEnvelope, HasTheColoursOfItsModel) {
  scene::Balloon balloon;
  balloon.envelope = scene::EnvelopeModel{"pyramid.obj", scene::UpAxis::y, 18.0, 0.0};
  const mesh::TriangleMesh cloth = special_envelope(balloon, pyramid());
  ASSERT_EQ(cloth.colors.size(), cloth.positions.size());
  const auto top = std::max_element(cloth.positions.begin(), cloth.positions.end(),
                                    [](const vec3& a, const vec3& b) { return a.y < b.y; });
  const auto at = static_cast<std::size_t>(top - cloth.positions.begin());
  EXPECT_EQ(cloth.colors[at], vec3(0.0f, 0.5f, 0.0f));
  const dvec3 mean = mean_color(pyramid());
  EXPECT_NEAR(mean.x, 0.5 * 2.0 / 3.0, 1e-6);
  EXPECT_NEAR(mean.y, 0.5 / 3.0, 1e-6);
}

}  // namespace
}  // namespace aerostat::world
