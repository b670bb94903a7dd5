// Tests the detail of the ground that follows neither height nor slope: the edges of woods, and
// what the wind carves into snow.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "ground/ground_numbers.hpp"
#include "probe.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kPoints = 4096;

struct Look {
  /// The albedo in green, and the light by a sun.
  std::vector<float> albedo, lit;
};

class GroundDetail : public LaneTest {
 protected:
  GroundDetail() : scene_(scene::defaults(scene::BiomeKind::snow, scene::View::outside)) {
    scene::Ground& ground = scene_.biome.ground;
    // All is white, smooth and level but for what a test adds.
    ground.cover_a = ground.cover_b = ground.snow = vec3(1.0f);
    ground.relief = ground.softness = ground.sparkle = 0.0;
    ground.strata_m = ground.forest_share = 0.0;
    ground.snow_line_m = -100000.0;
    ground.rock_slope_deg[0] = ground.snow_slope_deg[0] = 80.0;
    ground.rock_slope_deg[1] = ground.snow_slope_deg[1] = 85.0;
  }

  /// Returns points within some kilometres, each moved by `offset`.
  static std::vector<vec3> points(vec3 offset = vec3(0.0f)) {
    std::mt19937 random(29);
    std::uniform_real_distribution<float> across(-3000.0f, 3000.0f);
    std::vector<vec3> all;
    for (std::size_t i = 0; i < kPoints; ++i) {
      const float x = across(random), z = across(random);
      all.push_back(vec3(x, 100.0f, z) + offset);
    }
    return all;
  }

  /// Returns what the ground looks like at points of a slope whose normal leans towards x, in light
  /// from a quarter above the horizon.
  Look look(const std::vector<vec3>& at, float footprint, float slope_deg = 0.0f) const {
    const float angle = radians_from_degrees(slope_deg);
    const vec3 light = glm::normalize(vec3(0.6f, 0.25f, 0.6f));
    const std::vector<float> slope{std::sin(angle), std::cos(angle), 0.0f,
                                   light.x,         light.y,         light.z};
    const auto albedos = output<float>(at.size()), lit = output<float>(at.size());
    const AeroGround ground = ground::ground_numbers(scene_);
    probe_.run("probe_lit_ground", at.size(), input(std::vector<AeroGround>{ground}),
               input(planes(at)), input(slope), footprint, albedos, lit);
    return {albedos.read(), lit.read()};
  }

  static double mean(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) sum += static_cast<double>(value);
    return sum / static_cast<double>(values.size());
  }

  /// Returns the root mean square of the difference.
  static double difference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double step = static_cast<double>(a[i]) - static_cast<double>(b[i]);
      sum += step * step;
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
  }

  scene::Scene scene_;

 private:
  const Probe probe_{"ground.cl", GetParam()};
};

TEST_P(GroundDetail, WoodsAreClosedInside) {
  scene_.biome.ground.forest_share = 1.0;
  scene_.biome.ground.forest_top_m = 100000.0;
  const std::vector<float> albedo = look(points(), 0.1f).albedo;
  const auto open = std::count_if(albedo.begin(), albedo.end(), [](float a) { return a > 0.4f; });
  EXPECT_LT(open, 40);
}

// Single trees and gaps are seen from near. From afar their mean is left, within what the thinning
// out of woods makes of it.
TEST_P(GroundDetail, WoodsThinOutInClumpsThatLeaveTheirMean) {
  scene_.biome.ground.forest_share = 0.5;
  scene_.biome.ground.forest_top_m = 100000.0;
  const auto some = [](const std::vector<float>& albedo) {
    return std::count_if(albedo.begin(), albedo.end(),
                         [](float a) { return a > 0.15f && a < 0.85f; });
  };
  const std::vector<float> near = look(points(), 0.1f).albedo;
  const std::vector<float> far = look(points(), 60.0f).albedo;
  EXPECT_GT(some(near), 200);
  EXPECT_NEAR(mean(near), mean(far), 0.05);
  const std::vector<float> beside = look(points({8.0f * 6.0f, 0.0f, 0.0f}), 0.1f).albedo;
  EXPECT_GT(difference(near, beside), 0.2);
}

TEST_P(GroundDetail, DriftsLieAlongTheWind) {
  for (const double wind_deg : {0.0, 90.0}) {
    scene_.terrain.dunes.wind_deg = wind_deg;
    const std::vector<float> here = look(points(), 0.1f).lit;
    const std::vector<float> along_x = look(points({5.0f, 0.0f, 0.0f}), 0.1f).lit;
    const std::vector<float> along_z = look(points({0.0f, 0.0f, 5.0f}), 0.1f).lit;
    const double x = difference(here, along_x), z = difference(here, along_z);
    EXPECT_GT(std::min(x, z), 0.005) << wind_deg;
    const bool along_z_axis = wind_deg == 0.0;
    EXPECT_GT(along_z_axis ? x / z : z / x, 1.5) << wind_deg;
  }
}

TEST_P(GroundDetail, WallsAndFarFootprintsShowNoDrifts) {
  const std::vector<float> wall = look(points(), 0.1f, 60.0f).lit;
  EXPECT_EQ(difference(wall, std::vector<float>(kPoints, wall[0])), 0.0);
  const std::vector<float> far = look(points(), 200.0f).lit;
  EXPECT_EQ(difference(far, std::vector<float>(kPoints, far[0])), 0.0);
}

AEROSTAT_AT_EVERY_WIDTH(GroundDetail);

}  // namespace
}  // namespace aerostat::test
