// Tests that the ground over a footprint is the mean of what it is at the points of the footprint.
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "core/earth.hpp"
#include "ground/ground_numbers.hpp"
#include "probe.hpp"
#include "rules/ground.h"
#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kFootprints = 512, kInside = 64;
constexpr float kFootprint = 1.0f;

/// What a footprint shows, and what its points do.
struct Error {
  /// The mean difference between footprints and the means of their points.
  double bias = 0.0;
  /// The root mean squares of that difference, and of the difference between the middle point of a
  /// footprint and the mean.
  double filtered = 0.0, one_point = 0.0;
};

class GroundFilter : public LaneTest {
 protected:
  GroundFilter() {
    scene::Scene scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
    scene::Ground& ground = scene.biome.ground;
    // All waves are four footprints long or longer, so that a footprint shows all of them.
    ground.pattern_m = 640.0;
    ground.strata_m = 0.0;
    ground.forest_share = 0.0;
    ground.sparkle = 0.0;
    ground.softness = 0.0;
    ground_ = ground::ground_numbers(scene);
  }

  /// Returns the errors of the albedo and of the light on slopes of this angle.
  std::pair<Error, Error> errors(float slope_deg, unsigned seed) const {
    const float angle = radians_from_degrees(slope_deg);
    const vec3 normal(std::sin(angle), std::cos(angle), 0.0f);
    const vec3 down(normal.y, -normal.x, 0.0f), level(0.0f, 0.0f, 1.0f);
    const vec3 light = glm::normalize(vec3(0.5f, 0.5f, 0.6f));
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> across(-4000.0f, 4000.0f);
    std::normal_distribution<float> inside(0.0f, FOOTPRINT_SIGMA * kFootprint);
    std::vector<vec3> centres, points;
    for (std::size_t i = 0; i < kFootprints; ++i) {
      const vec3 centre = across(random) * level + across(random) * down;
      centres.push_back(centre);
      for (std::size_t k = 0; k < kInside; ++k) {
        points.push_back(centre + inside(random) * level + inside(random) * down);
      }
    }
    const std::vector<float> slope{normal.x, normal.y, normal.z, light.x, light.y, light.z};
    const auto over = values(centres, slope, kFootprint), middles = values(centres, slope, 1e-3f);
    const auto each = values(points, slope, 1e-3f);
    return {error(over[0], middles[0], each[0]), error(over[1], middles[1], each[1])};
  }

  using Values = std::array<std::vector<float>, 2>;

  /// Returns the albedos of points and the light on them.
  Values values(const std::vector<vec3>& points, const std::vector<float>& slope,
                float footprint) const {
    const auto albedos = output<float>(points.size()), lit = output<float>(points.size());
    probe_.run("probe_lit_ground", points.size(), input(std::vector<AeroGround>{ground_}),
               input(planes(points)), input(slope), footprint, albedos, lit);
    return {albedos.read(), lit.read()};
  }

  AeroGround ground_{};

 private:
  static Error error(const std::vector<float>& over, const std::vector<float>& middles,
                     const std::vector<float>& each) {
    Error error;
    for (std::size_t i = 0; i < kFootprints; ++i) {
      double mean = 0.0;
      for (std::size_t k = 0; k < kInside; ++k) mean += static_cast<double>(each[i * kInside + k]);
      mean /= static_cast<double>(kInside);
      const double filtered = static_cast<double>(over[i]) - mean;
      const double one_point = static_cast<double>(middles[i]) - mean;
      error.bias += filtered / static_cast<double>(kFootprints);
      error.filtered += filtered * filtered / static_cast<double>(kFootprints);
      error.one_point += one_point * one_point / static_cast<double>(kFootprints);
    }
    error.filtered = std::sqrt(error.filtered);
    error.one_point = std::sqrt(error.one_point);
    return error;
  }

  const Probe probe_{"ground.cl", GetParam()};
};

// Snow and rock differ by 0.7 in albedo. The bias, 0.003 and 0.008, is held to a hundredth or two
// of that. The shortest waves here are the shortest that a footprint shows in full, which is the
// hardest case: the error of a footprint is 0.64 to 0.81 of that of the point in its middle.
TEST_P(GroundFilter, IsTheMeanOfThePointsInsideAFootprint) {
  for (const float slope_deg : {44.0f, 50.0f, 56.0f}) {
    const auto [albedo, lit] = errors(slope_deg, 71u);
    EXPECT_NEAR(albedo.bias, 0.0, 0.012) << slope_deg;
    EXPECT_NEAR(lit.bias, 0.0, 0.02) << slope_deg;
    EXPECT_LT(albedo.filtered, 0.85 * albedo.one_point) << slope_deg;
    EXPECT_LT(lit.filtered, 0.85 * lit.one_point) << slope_deg;
  }
}

// 45 km away, curved land lies 138 m lower. Snow lies there as on level land of the same height
// above the sea.
TEST_P(GroundFilter, GoesByHeightsAboveTheCurvedSea) {
  ground_.snow_line = 1000.0f;
  ground_.snow_fuzz = 100.0f;
  std::mt19937 random(17);
  std::uniform_real_distribution<float> across(40000.0f, 50000.0f), height(800.0f, 1200.0f);
  std::vector<vec3> level, curved;
  for (std::size_t i = 0; i < kFootprints; ++i) {
    const vec3 p(across(random), height(random), -1000.0f);
    level.push_back(p);
    const double fall = kEarthFall_per_m * (double{p.x} * p.x + 1e6);
    curved.emplace_back(p.x, static_cast<float>(p.y - fall), p.z);
  }
  const std::vector<float> up{0.0f, 1.0f, 0.0f, 0.0f, 1.0f, 0.0f};
  const std::vector<float> expected = values(level, up, kFootprint)[0];
  const std::vector<float> lower = values(curved, up, kFootprint)[0];
  ground_.fall = static_cast<float>(kEarthFall_per_m);
  const std::vector<float> found = values(curved, up, kFootprint)[0];
  double off = 0.0, off_without = 0.0;
  for (std::size_t i = 0; i < kFootprints; ++i) {
    off += std::fabs(found[i] - expected[i]) / kFootprints;
    off_without += std::fabs(lower[i] - expected[i]) / kFootprints;
  }
  EXPECT_LT(off, 2e-3);
  EXPECT_GT(off_without, 0.1);
}

AEROSTAT_AT_EVERY_WIDTH(GroundFilter);

}  // namespace
}  // namespace aerostat::test
