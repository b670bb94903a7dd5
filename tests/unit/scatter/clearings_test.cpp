// Tests that nothing grows in clearings, and that all else stays as it is.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "mesh_over.hpp"
#include "scatter/scatter.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "support/resolved.hpp"

namespace aerostat::scatter {
namespace {

bool is_in(const scene::Clearing& clearing, const Instance& instance) {
  const dvec2 foot(instance.position.x, instance.position.z);
  return glm::distance(foot, clearing.center) < clearing.radius_m;
}

bool is_same(const Instance& a, const Instance& b) {
  return a.position == b.position && a.scale == b.scale && a.yaw_rad == b.yaw_rad;
}

TEST(Clearings, NothingGrowsThereAndAllElseStays) {
  scene::Scene scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  scene.terrain.cells = 4;
  scene.biome.ground.forest_share = 1.0;
  scene.biome.ground.forest_top_m = 1e5;
  scene.camera.position = {400.0, 500.0, 0.0};
  scene.balloon.enabled = false;
  const mesh::GridMesh ground = mesh_over(4, 1000.0, [](double, double) { return 100.0; });
  const auto all = scatter(test::resolved(scene), ground).instances;
  for (int i = 0; i < 300; ++i) {
    const double at = -300.0 + 2.0 * i;
    scene.vegetation.clearings.push_back({{at, 0.5 * at}, 9.0});
  }
  scene.vegetation.clearings.push_back({{-200.0, 250.0}, 60.0});
  const auto left = scatter(test::resolved(scene), ground).instances;
  // A plant keeps out with a third of its height, and none here is as tall as 40 m.
  constexpr double kReach_m = 14.0;
  std::size_t next = 0, cleared = 0;
  for (const Instance& plant : all) {
    double nearest = 1e9;
    bool is_cleared = false;
    for (const scene::Clearing& one : scene.vegetation.clearings) {
      const dvec2 foot(plant.position.x, plant.position.z);
      nearest = std::min(nearest, glm::distance(foot, one.center) - one.radius_m);
      is_cleared = is_cleared || is_in(one, plant);
    }
    const bool is_left = next < left.size() && is_same(left[next], plant);
    if (is_left) ++next;
    EXPECT_FALSE(is_left && is_cleared);
    EXPECT_TRUE(is_left || nearest < kReach_m);
    cleared += is_cleared ? 1 : 0;
  }
  EXPECT_EQ(next, left.size()) << "no plant is new";
  EXPECT_GT(cleared, 500u);
}

}  // namespace
}  // namespace aerostat::scatter
