// Tests which object a point in the world belongs to.
#include "world/pick.hpp"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "model/envelope_shape.hpp"
#include "model/rigging.hpp"
#include "scene/scene.hpp"
#include "world/scene_models.hpp"

namespace aerostat::world {
namespace {

/// Models of 20 x 10 x 4 m that stand in a scene.
class PickedModels : public testing::Test {
 protected:
  scene::PlacedModel& place(const dvec3& position) {
    scene::PlacedModel& placed = scene_.objects.emplace_back();
    placed.position = position;
    return placed;
  }

  std::optional<std::size_t> at(const dvec3& point) const {
    SceneModels models;
    auto model = std::make_shared<FileModel>();
    model->size = {20.0, 10.0, 4.0};
    models.models.push_back(std::move(model));
    models.of_object.assign(scene_.objects.size(), 0);
    return object_at(scene_, models, point);
  }

  scene::Scene scene_;
};

TEST_F(PickedModels, HoldThePointsOfTheirPlan) {
  place({100.0, 0.0, 50.0});
  EXPECT_EQ(at({109.5, 3.0, 51.0}), 0u);
  EXPECT_EQ(at({100.0, 3.0, 54.0}), std::nullopt);
  EXPECT_EQ(at({112.0, 3.0, 50.0}), std::nullopt);
  // Turned by a quarter, it reaches to the north and south.
  scene_.objects[0].heading_deg = 90.0;
  EXPECT_EQ(at({100.0, 3.0, 59.0}), 0u);
  EXPECT_EQ(at({109.5, 3.0, 51.0}), std::nullopt);
  // At 45 degrees clockwise, its east end lies in the south-east.
  scene_.objects[0].heading_deg = 45.0;
  EXPECT_EQ(at({106.5, 3.0, 56.5}), 0u);
  EXPECT_EQ(at({106.5, 3.0, 43.5}), std::nullopt);
}

TEST_F(PickedModels, OfWhichTheSmallestCounts) {
  place({0.0, 0.0, 0.0}).scale = 3.0;
  place({5.0, 0.0, 0.0}).height_m = 5.0;
  EXPECT_EQ(at({6.0, 1.0, 0.0}), 1u);
  EXPECT_EQ(at({-6.0, 1.0, 0.0}), 0u);
  EXPECT_EQ(at({16.0, 1.0, 0.0}), 0u);
}

TEST_F(PickedModels, BelongToTheirAreaIfTheyAreStrewn) {
  scene::PlacedModel& strewn = place({0.0, 0.0, 0.0});
  strewn.count = 30;
  strewn.area = scene::PlacedArea();
  strewn.area->size_m = {200.0, 100.0};
  place({20.0, 0.0, 0.0});
  EXPECT_EQ(at({80.0, 1.0, 40.0}), 0u);
  EXPECT_EQ(at({20.0, 1.0, 1.0}), 1u) << "a model that stands alone is smaller than an area";
  EXPECT_EQ(at({80.0, 1.0, 90.0}), std::nullopt);
}

TEST(PickedBalloon, IsTheNearestThatIsThere) {
  scene::Scene scene;
  scene.balloon.position = {0.0, 100.0, 0.0};
  scene.balloons.resize(2, scene.balloon);
  scene.balloons[0].position = {60.0, 100.0, 0.0};
  scene.balloons[1].position = {30.0, 100.0, 0.0};
  scene.balloons[1].enabled = false;
  EXPECT_EQ(balloon_at(scene, {8.0, 112.0, 0.0}), 0u);
  EXPECT_EQ(balloon_at(scene, {52.0, 112.0, 3.0}), 1u);
  EXPECT_EQ(balloon_at(scene, {31.0, 112.0, 3.0}), 1u) << "the balloon between them is not there";
  scene.balloon.enabled = scene.balloons[0].enabled = false;
  EXPECT_EQ(balloon_at(scene, {8.0, 112.0, 0.0}), std::nullopt);
}

TEST(PickedCloth, HasTheDirectionAndTheHeightOfThePoint) {
  scene::Balloon balloon;
  balloon.position = {10.0, 200.0, -30.0};
  balloon.heading_deg = 30.0;
  const model::EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  const dvec3 mouth = balloon.position + dvec3(0.0, model::mouth_height(balloon.diameter_m), 0.0);
  for (const double share : {0.2, 0.5, 0.8}) {
    const double arc = shape.mouth_arc() + share * (shape.plate_arc() - shape.mouth_arc());
    const dvec3 place = shape.fabric(3, 0.5, {arc, 0.0}).position;
    const ClothPlace found = cloth_place(balloon, mouth + place);
    EXPECT_NEAR(found.height_m, arc - shape.mouth_arc(), 1e-6);
    const double azimuth_deg = glm::degrees(std::atan2(place.x, -place.z));
    EXPECT_NEAR(std::remainder(found.around_deg + 30.0 - azimuth_deg, 360.0), 0.0, 1e-9);
  }
  // East of a balloon that flies to the north is 90 degrees clockwise.
  balloon.heading_deg = 0.0;
  EXPECT_NEAR(cloth_place(balloon, mouth + dvec3(9.0, 9.0, 0.0)).around_deg, 90.0, 1e-9);
}

TEST(Ground, IsFoundAlongARay) {
  const auto hill = [](double x, double) { return x > 500.0 ? 80.0 : 20.0; };
  const auto flat = distance_to_ground({0, 120, 0}, glm::normalize(dvec3(1, -1, 0)), hill);
  ASSERT_TRUE(flat);
  EXPECT_NEAR(*flat, 100.0 * std::sqrt(2.0), 1e-6);
  const auto cliff = distance_to_ground({0, 60, 0}, dvec3(1, 0, 0), hill);
  ASSERT_TRUE(cliff);
  EXPECT_NEAR(*cliff, 500.0, 1e-6);
  EXPECT_FALSE(distance_to_ground({0, 60, 0}, dvec3(-1, 0, 0), hill));
  EXPECT_FALSE(distance_to_ground({0, 60, 0}, dvec3(0, 1, 0), hill));
}

}  // namespace
}  // namespace aerostat::world
