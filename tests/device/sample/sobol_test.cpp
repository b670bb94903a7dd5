// Tests the pairs of numbers that paths take, and the directions of the sky that they choose.
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "camera.h"
#include "pack/sky_importance.hpp"
#include "shading_scene.hpp"

namespace aerostat::test {
namespace {

using Word = std::uint32_t;

constexpr Word kSide = 8;

/// The points that the samples of a square of pixels take for a pair, by the pixel.
using PointsOfPixels = std::map<Word, std::vector<glm::vec2>>;

class PathPairs : public LaneTest {
 protected:
  PointsOfPixels choose(Word samples, Word pair) const {
    const auto log2_lanes = static_cast<Word>(std::bit_width(static_cast<Word>(GetParam()))) - 1;
    AeroLaunch launch{};
    launch.frame.samples = samples;
    launch.frame.sample_shift = 0x9e3779b9u;
    launch.frame.width = kSide;
    launch.tile = {0, 0, kSide, kSide, 0, 0, 0, log2_lanes - log2_lanes / 2, log2_lanes / 2, 0};
    launch.tile.blocks_per_row = kSide >> launch.tile.log2_w;
    launch.tile.block_count = launch.tile.blocks_per_row * (kSide >> launch.tile.log2_h);
    const std::size_t count = kSide * kSide;
    PointsOfPixels points;
    for (launch.tile.first_sample = 0; launch.tile.first_sample < samples;
         ++launch.tile.first_sample) {
      const auto pixels = output<Word>(count);
      const auto us = output<float>(count), vs = output<float>(count);
      probe.run("probe_path_pairs", count, launch, pair, pixels, us, vs);
      const auto p = pixels.read();
      const auto u = us.read(), v = vs.read();
      for (std::size_t i = 0; i < count; ++i) points[p[i]].emplace_back(u[i], v[i]);
    }
    return points;
  }

  const Probe probe{"sobol.cl", GetParam()};
};

AEROSTAT_AT_EVERY_WIDTH(PathPairs);

/// Returns whether every rectangle of `columns` x (points / columns) in the unit square holds one
/// point.
bool fills_rectangles(const std::vector<glm::vec2>& points, Word columns) {
  const auto count = static_cast<Word>(points.size());
  std::set<Word> seen;
  for (const glm::vec2& p : points) {
    const auto column = static_cast<Word>(p.x * static_cast<float>(columns));
    const auto row = static_cast<Word>(p.y * static_cast<float>(count / columns));
    seen.insert(row * columns + column);
  }
  return seen.size() == points.size();
}

/// The samples of a pixel are a net: every way of dividing the square into as many equal rectangles
/// as there are points, with powers of two along the sides, has one point in each. The samples of
/// squares of pixels are nets, too.
TEST_P(PathPairs, AreNetsInPixelsAndInSquaresOfPixels) {
  for (const Word pair : {0u, 1u, 7u, 23u}) {
    const PointsOfPixels points = choose(16, pair);
    ASSERT_EQ(points.size(), kSide * kSide);
    std::vector<glm::vec2> of_square;
    for (const auto& [pixel, inside] : points) {
      for (const Word columns : {1u, 2u, 4u, 8u, 16u}) {
        EXPECT_TRUE(fills_rectangles(inside, columns)) << pair << " at " << pixel;
      }
      if (pixel % kSide < 4 && pixel / kSide < 4) {
        of_square.insert(of_square.end(), inside.begin(), inside.end());
      }
    }
    for (Word columns = 1; columns <= 256; columns *= 2) {
      EXPECT_TRUE(fills_rectangles(of_square, columns)) << pair << ", " << columns;
    }
  }
}

/// The first samples of a pixel are a net as well, since adaptive sampling may stop after them.
TEST_P(PathPairs, BeginWithANet) {
  for (auto [pixel, points] : choose(64, 3)) {
    points.resize(16);
    EXPECT_TRUE(fills_rectangles(points, 4)) << pixel;
  }
}

double mean_product(const PointsOfPixels& a, const PointsOfPixels& b) {
  double sum = 0.0, count = 0.0;
  for (const auto& [pixel, points] : a) {
    const auto& others = b.at(pixel);
    for (std::size_t i = 0; i < points.size(); ++i) {
      sum += (static_cast<double>(points[i].x) - 0.5) * (static_cast<double>(others[i].y) - 0.5);
      count += 1.0;
    }
  }
  return sum / count;
}

/// Numbers of different pairs do not depend on each other. The product of two independent numbers
/// around 0 has a standard deviation of 1/12.
TEST_P(PathPairs, DoNotDependOnEachOther) {
  std::vector<PointsOfPixels> pairs;
  for (Word pair = 0; pair < 8; ++pair) pairs.push_back(choose(16, pair));
  const double noise = 1.0 / (12.0 * std::sqrt(16.0 * kSide * kSide));
  for (std::size_t a = 0; a < pairs.size(); ++a) {
    for (std::size_t b = 0; b < pairs.size(); ++b) {
      if (a == b) continue;
      EXPECT_LT(std::abs(mean_product(pairs[a], pairs[b])), 4.5 * noise) << a << ", " << b;
    }
  }
}

/// Returns a sky that is bright around a sun at some height, and has a horizon below level.
pack::PackedScene sky_with_a_sun(const vec3& sun) {
  pack::PackedScene scene = with_even_sky(bare_scene(), vec3(0.02f));
  set3(scene.numbers.sky.sun_direction, glm::normalize(sun));
  scene.numbers.air.haze_asymmetry = 0.76f;
  scene.numbers.air.horizon_sine = 0.02f;
  for (AeroSkyCell& cell : scene.sky_table) set3(cell.haze, vec3(0.3f));
  return scene;
}

class SkyImportance : public LaneTest {
 protected:
  static constexpr std::size_t kSamples = 1u << 15;
  const Probe probe{"sobol.cl", GetParam()};
};

AEROSTAT_AT_EVERY_WIDTH(SkyImportance);

/// The mean of 1 / density over choices within a cap is the solid angle of the cap.
TEST_P(SkyImportance, ChooseDirectionsByTheirDensities) {
  std::mt19937 random(29);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<float> us(kSamples), vs(kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) {
    us[i] = std::min(unit(random), 0.9999999f);
    vs[i] = std::min(unit(random), 0.9999999f);
  }
  for (const vec3& sun : {vec3(0.3f, 0.25f, -0.8f), vec3(0.0f, 1.0f, 0.0f)}) {
    const pack::PackedScene scene = sky_with_a_sun(sun);
    const AeroSkyImportance importance = pack::sky_importance(scene.numbers, scene.sky_table);
    const auto directions = output<float>(3 * kSamples), densities = output<float>(kSamples);
    probe.run("probe_sky_directions", kSamples, uploaded(scene.numbers),
              input(std::vector<AeroSkyImportance>{importance}), input(us), input(vs), directions,
              densities);
    const auto d = directions.read();
    const auto p = densities.read();
    for (const vec3& axis :
         {glm::normalize(sun), vec3(0, 1, 0), vec3(0, -1, 0), tilted(85.0f), tilted(-85.0f)}) {
      for (const double cosine : {0.4, 0.8, 0.95}) {
        double sum = 0.0, squares = 0.0;
        for (std::size_t i = 0; i < kSamples; ++i) {
          ASSERT_GT(p[i], 0.0f);
          const vec3 direction = from_planes(d, i);
          ASSERT_NEAR(glm::length(direction), 1.0f, 1e-5f);
          if (static_cast<double>(glm::dot(direction, axis)) <= cosine) continue;
          sum += 1.0 / static_cast<double>(p[i]);
          squares += 1.0 / (static_cast<double>(p[i]) * static_cast<double>(p[i]));
        }
        const double count = static_cast<double>(kSamples), mean = sum / count;
        const double noise = std::sqrt((squares / count - mean * mean) / count);
        EXPECT_NEAR(mean, 2.0 * std::numbers::pi * (1.0 - cosine), 4.5 * noise) << cosine;
      }
    }
  }
}

/// Rays to the sky are traced under a bright sun in haze, and not under an even sky.
TEST(SkyImportanceOnTheHost, SayWhetherTheSkyIsSought) {
  pack::PackedScene scene = sky_with_a_sun({0.3f, 0.25f, -0.8f});
  EXPECT_EQ(pack::sky_importance(scene.numbers, scene.sky_table).sought, 1u);
  scene = with_even_sky(bare_scene(), vec3(0.02f));
  EXPECT_EQ(pack::sky_importance(scene.numbers, scene.sky_table).sought, 0u);
}

/// The density is high where the sky is bright, and low below the horizon.
TEST_P(SkyImportance, FollowTheLightOfTheSky) {
  const vec3 sun = glm::normalize(vec3(0.3f, 0.25f, -0.8f));
  const pack::PackedScene scene = sky_with_a_sun(sun);
  const AeroSkyImportance importance = pack::sky_importance(scene.numbers, scene.sky_table);
  const std::size_t count = whole_packets(3);
  std::vector<vec3> directions{sun, {0, 1, 0}, {0, -1, 0}};
  directions.resize(count, {0, 1, 0});
  const auto densities = output<float>(count);
  probe.run("probe_sky_densities", count, uploaded(scene.numbers),
            input(std::vector<AeroSkyImportance>{importance}), input(planes(directions)),
            densities);
  const auto p = densities.read();
  EXPECT_GT(p[0], 10.0f * p[1]) << "towards the sun and up";
  EXPECT_GT(p[1], 4.0f * p[2]) << "up and down";
}

}  // namespace
}  // namespace aerostat::test
