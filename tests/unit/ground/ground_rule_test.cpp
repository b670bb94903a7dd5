// Tests the noise of the ground on the host.
#include "ground/ground_rule.hpp"

#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "ground/ground_numbers.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::ground {
namespace {

TEST(GroundRule, LooksUpLandCoverNearThePlace) {
  scene::Scene scene = scene::defaults(scene::BiomeKind::sand, scene::View::outside);
  scene.terrain.cover.source = "cover.tif";
  const AeroGround numbers = ground_numbers(scene);
  // Woods in the east, and no more ground beyond 2 km.
  const CoverLookup cover{[](double x, double) {
                            CoverShares shares{};
                            if (x < 2000.0) shares[x > 0.0 ? 0 : 4] = 1.0f;
                            return shares;
                          },
                          30.0f};
  const GroundRule rule(numbers, 1.0f, &cover);
  std::vector<vec3> points;
  for (int i = 0; i < 200; ++i)
    points.emplace_back(-900.0f + 18.0f * static_cast<float>(i), 5.0f, 7.0f);
  const std::vector<GroundNoise> noise = rule.noise(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float forest = rule.forest(points[i], 1.0f, noise[i]);
    // Noise moves borders by at most 40 m or so.
    const float x = points[i].x;
    if (x < -60.0f || x > 2060.0f) {
      EXPECT_EQ(forest, 0.0f) << x;
    } else if (x > 60.0f && x < 1900.0f) {
      EXPECT_GT(forest, 0.4f) << x;
    }
    EXPECT_GE(rule.forest_at_most(points[i], noise[i]), forest);
  }
  EXPECT_EQ(rule.highest_tree(), kInfinity);
}

TEST(GroundNoise, IsTheSamePartByPartAndInAnyNumber) {
  const scene::Scene scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  const GroundRule rule(ground_numbers(scene), 1.0f);
  std::mt19937 random(4);
  std::uniform_real_distribution<float> place(-3000.0f, 3000.0f);
  std::vector<vec3> points;
  for (int i = 0; i < 300; ++i) points.push_back({place(random), place(random), place(random)});
  const std::vector<GroundNoise> all = rule.noise(points);
  for (const std::size_t count : {1u, 2u, 15u, 16u, 17u, 128u, 129u, 299u}) {
    std::vector<GroundNoise> some(count);
    rule.fill_rough(std::span(points).first(count), some);
    rule.fill_smooth(std::span(points).first(count), some);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(some[i].broad, all[i].broad);
      EXPECT_EQ(some[i].fine, all[i].fine);
      EXPECT_EQ(some[i].rough, all[i].rough);
    }
  }
}

}  // namespace
}  // namespace aerostat::ground
