// Tests that plants leave room for all of a film's ways, and the same in each frame.
#include "film/clearings.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "film/timeline.hpp"
#include "scatter/obstacle.hpp"
#include "scene/balloons.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"

namespace aerostat::film {
namespace {

/// Returns whether a circle lies within others, by points on its rim and its middle.
bool is_covered(const std::vector<scene::Clearing>& by, const dvec3& middle, double radius_m) {
  constexpr int kPoints = 64;
  for (int i = 0; i <= kPoints; ++i) {
    const double turn = 2.0 * M_PI * i / kPoints, radius = i == kPoints ? 0.0 : radius_m;
    const dvec2 at = dvec2(middle.x, middle.z) + radius * dvec2(std::cos(turn), std::sin(turn));
    const bool is_held = std::any_of(by.begin(), by.end(), [&](const scene::Clearing& one) {
      return glm::distance(one.center, at) <= one.radius_m + 1e-9;
    });
    if (!is_held) return false;
  }
  return true;
}

TEST(Clearings, CoverTheLowPartsOfAWay) {
  // Flies along x at 7 m/s, is at 100 m for the second half, and the ground is at 10 m.
  const auto flyers = [](double time_s) {
    return std::vector<Flyer>{{{7.0 * time_s, time_s < 5.0 ? 20.0 : 110.0, 3.0}, 6.0}};
  };
  const auto all = clearings_along(flyers, 10.0, [](double, double) { return 10.0; });
  for (double time = 0.0; time < 4.95; time += 0.013) {
    EXPECT_TRUE(is_covered(all, {7.0 * time, 0.0, 3.0}, 6.0)) << time;
  }
  for (const scene::Clearing& one : all) {
    EXPECT_LT(one.center.x, 36.0);
    EXPECT_LT(one.radius_m, 9.0);
  }
  EXPECT_LT(all.size(), 20u);
}

TEST(Clearings, HoldTheRoomOfEveryFrame) {
  terrain::ReliefCache reliefs;
  Timeline timeline(scene::SceneSource::from_text(R"({
    "version": 1, "biome": "snow", "terrain": {"cells": 64},
    "balloon": {"position": [0, 20, 0]},
    "balloons": [{"position": [60, 5, -80]}, {"position": [0, 300, -80]}],
    "camera": {"height_above": "ground", "position": [-30, 12, 90], "target": [0, 30, 0]},
    "film": {"duration_s": 6, "fps": 10, "wind": [{"speed_m_s": 6, "from_deg": 230}],
             "camera": {"mode": "chase"}}})",
                                                  "low.json"),
                    reliefs);
  const auto expected = timeline.scene_at(1).vegetation.clearings;
  ASSERT_FALSE(expected.empty());
  for (int frame = 1; frame <= 60; ++frame) {
    scene::Scene scene = timeline.scene_at(frame);
    EXPECT_EQ(scene.vegetation.clearings, expected);
    const auto& circles = scene.vegetation.clearings;
    const dvec3 eye = world::resolve(scene, reliefs).eye();
    EXPECT_TRUE(is_covered(circles, eye, scatter::kRoomOfEye_m)) << frame;
    for (const scene::Balloon* balloon : scene::all_balloons(scene)) {
      const dvec3& at = balloon->position;
      const bool is_low = at.y - timeline.ground_at(at.x, at.z) < scatter::kClear_m;
      const double room_m = scatter::room_of(balloon->diameter_m);
      EXPECT_EQ(is_covered(circles, at, room_m), is_low) << frame;
    }
  }
}

}  // namespace
}  // namespace aerostat::film
