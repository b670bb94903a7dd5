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
