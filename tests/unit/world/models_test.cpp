// Tests where the group of models puts them, on a ground that is given.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "scene/io.hpp"
#include "support/resolved.hpp"
#include "world/kinds.hpp"
#include "world/scene_models.hpp"

namespace aerostat::world {
namespace {

/// Ground that rises by 1 m for each 4 m to the east, and is at 100 m in the middle.
mesh::GridMesh slope() {
  const std::vector<float> lines{-64.0f, 0.0f, 64.0f};
  mesh::GridMesh ground(lines, lines);
  for (std::uint32_t j = 0; j < 3; ++j) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      ground.set(i, j, 100.0f + 0.25f * lines[i], glm::normalize(vec3(-0.25f, 1.0f, 0.0f)));
    }
  }
  return ground;
}

/// A pyramid of 8 x 8 m that is 6 m high.
FileModel pyramid() {
  asset::Primitive primitive;
  primitive.positions = {{0, 0, 0}, {8, 0, 0}, {8, 0, 8}, {0, 0, 8}, {4, 6, 4}};
  primitive.triangles = {{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
  asset::Model model;
  model.materials.resize(1);
  model.meshes.push_back({"pyramid", {primitive}});
  model.placements.push_back({});
  return file_model({"pyramid.obj", {}}, std::move(model));
}

/// The pyramid in the places that a test gives it.
class PlacedPyramids : public testing::Test {
 protected:
  scene::PlacedModel& place(const dvec3& position) {
    scene::PlacedModel& placed = scene_.objects.emplace_back();
    placed.position = position;
    return placed;
  }

  std::vector<scatter::Instance> places() {
    const scene::ResolvedScene scene = test::resolved(scene_);
    const GroupRequest request{scene, models()};
    const mesh::GridMesh ground = slope();
    terrain::ReliefCache reliefs;
    const Shape shape = kModels.build({request, *scene, &ground, reliefs});
    return std::get<Instances>(shape).places;
  }

  std::vector<scatter::Obstacle> obstacles() {
    const scene::ResolvedScene scene = test::resolved(scene_);
    return kModels.obstacles({scene, models()});
  }

  std::shared_ptr<const SceneModels> models() const {
    auto models = std::make_shared<SceneModels>();
    models->models.push_back(std::make_shared<const FileModel>(pyramid()));
    models->first_material.push_back(0);
    models->of_object.assign(scene_.objects.size(), 0);
    return models;
  }

  scene::Scene scene_ = scene::defaults(scene::BiomeKind::sand, scene::View::outside);
};

TEST_F(PlacedPyramids, NeverHoverOverASlope) {
  place({20, 0, 0});
  scene::PlacedModel& turned = place({20, -0.5, 0});
  turned.heading_deg = 45.0;
  turned.scale = 0.5;
  place({20, 2, 0}).height_above = scene::HeightReference::sea;
  const auto found = places();
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(found[0].position.y, 100.0f + 0.25f * (20.0f - 4.0f), 1e-3f) << "its west side";
  const float corner = 2.0f * std::sqrt(2.0f);
  EXPECT_NEAR(found[1].position.y, 99.5f + 0.25f * (20.0f - corner), 1e-3f) << "its west corner";
  EXPECT_EQ(found[2].position.y, 2.0f);
  EXPECT_EQ(found[1].scale, 0.5f);
}

TEST_F(PlacedPyramids, KeepPlantsAway) {
  place({20, 0, 7}).height_m = 12.0;
  place({0, 300, 0}).height_above = scene::HeightReference::sea;
  const auto found = obstacles();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].position, dvec3(20, 0, 7));
  EXPECT_TRUE(found[0].above_ground);
  EXPECT_NEAR(found[0].width_m, 16.0 * std::sqrt(2.0), 1e-9) << "twice as large as in the file";
  EXPECT_FALSE(found[1].above_ground);
}

TEST_F(PlacedPyramids, AreStrewnBySeedAndRules) {
  scene::PlacedModel& placed = place({10, 0, 5});
  placed.count = 50;
  placed.area = scene::PlacedArea();
  placed.area->size_m = {40.0, 60.0};
  placed.area->apart_m = 3.0;
  placed.area->sizes = {0.5, 2.0};
  const auto found = places();
  ASSERT_EQ(found.size(), 50u);
  float least = 10.0f, most = 0.0f;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const vec3& at = found[i].position;
    EXPECT_LE(std::abs(at.x - 10.0f), 20.0f);
    EXPECT_LE(std::abs(at.z - 5.0f), 30.0f);
    EXPECT_LT(at.y, 100.0f + 0.25f * at.x) << "its west side stands on the ground";
    EXPECT_GT(at.y, 100.0f + 0.25f * (at.x - 12.0f));
    least = std::min(least, found[i].scale);
    most = std::max(most, found[i].scale);
    for (std::size_t k = 0; k < i; ++k) {
      const vec3& other = found[k].position;
      EXPECT_GE(glm::distance(vec2(at.x, at.z), vec2(other.x, other.z)), 3.0f);
    }
  }
  EXPECT_GE(least, 0.5f);
  EXPECT_LT(least, 0.7f);
  EXPECT_GT(most, 1.7f);
  // The same seed gives the same places, and a greater count adds to them.
  placed.count = 60;
  const auto more = places();
  ASSERT_EQ(more.size(), 60u);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(more[i].position, found[i].position);
  placed.area->seed = 2;
  EXPECT_NE(places()[0].position, found[0].position);
}

TEST_F(PlacedPyramids, StandOnlyWhereRulesAllow) {
  scene_.biome.water.enabled = true;
  scene_.biome.water.level_m = 100.0;
  scene::PlacedModel& placed = place({0, 0, 0});
  placed.count = 40;
  placed.area = scene::PlacedArea();
  placed.area->size_m = {120.0, 120.0};
  // The west of the ground lies below the water.
  for (const scatter::Instance& one : places()) EXPECT_GE(one.position.x, 0.0f);
  placed.area->on = scene::PlacedOn::water;
  for (const scatter::Instance& one : places()) {
    EXPECT_LE(one.position.x, 0.0f);
    EXPECT_EQ(one.position.y, 100.0f) << "it floats";
  }
  placed.area->on = scene::PlacedOn::anywhere;
  placed.area->heights_m = {104.0, 108.0};
  auto found = places();
  EXPECT_EQ(found.size(), 40u);
  for (const scatter::Instance& one : found) {
    EXPECT_GE(one.position.x, 16.0f);
    EXPECT_LE(one.position.x, 32.0f);
  }
  // The slope is 14 degrees everywhere.
  placed.area->slope_deg = {0.0, 13.0};
  EXPECT_TRUE(places().empty());
  placed.area->slope_deg = {13.0, 15.0};
  EXPECT_EQ(places().size(), 40u);
  // There is no room for 40 pyramids that are 30 m apart.
  placed.area->apart_m = 30.0;
  found = places();
  EXPECT_GT(found.size(), 2u);
  EXPECT_LT(found.size(), 20u);
}

}  // namespace
}  // namespace aerostat::world
