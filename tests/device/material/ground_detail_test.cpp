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

  /// Returns what the ground looks like at points of a slope whose normal leans towards x.
  Look look(const std::vector<vec3>& at, float footprint, float slope_deg = 0.0f,
            vec3 light = glm::normalize(vec3(0.6f, 0.25f, 0.6f))) const {
    const float angle = radians_from_degrees(slope_deg);
    const std::vector<float> slope{std::sin(angle), std::cos(angle), 0.0f,
                                   light.x,         light.y,         light.z};
    const auto albedos = output<float>(at.size()), lit = output<float>(at.size());
    const AeroGround ground = ground::ground_numbers(scene_);
    probe_.run("probe_lit_ground", at.size(), input(std::vector<AeroGround>{ground}),
               input(planes(at)), input(slope), footprint, albedos, lit);
    return {albedos.read(), lit.read()};
  }

  /// Returns the share of the ground that crowns cover, inside of woods, where clumps are seen over
  /// this footprint.
  std::vector<float> crown_cover(float footprint) const {
    const std::vector<vec3> at = points();
    const auto covers = output<float>(at.size());
    const AeroGround ground = ground::ground_numbers(scene_);
    probe_.run("probe_crown_cover", at.size(), input(std::vector<AeroGround>{ground}),
               input(planes(at)), footprint, covers);
    return covers.read();
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

TEST_P(GroundDetail, WoodsThinOutInClumpsThatLeaveTheirMean) {
  scene_.biome.ground.forest_share = 0.5;
  scene_.biome.ground.forest_top_m = 100000.0;
  const std::vector<float> near = crown_cover(1.0f), far = crown_cover(100.0f);
  EXPECT_GT(difference(near, far), 0.1);
  EXPECT_NEAR(mean(near), mean(far), 0.04);
}

TEST_P(GroundDetail, DriftsLieAlongTheWind) {
  const vec3 from_x = glm::normalize(vec3(1.0f, 0.4f, 0.0f));
  const vec3 from_z = glm::normalize(vec3(0.0f, 0.4f, 1.0f));
  for (const double wind_deg : {0.0, 90.0}) {
    scene_.terrain.dunes.wind_deg = wind_deg;
    const bool is_along_z = wind_deg == 0.0;
    const vec3 across = is_along_z ? from_x : from_z, along = is_along_z ? from_z : from_x;
    const auto contrast = [&](const vec3& light) {
      const std::vector<float> lit = look(points(), 0.1f, 0.0f, light).lit;
      return difference(lit, std::vector<float>(kPoints, static_cast<float>(mean(lit))));
    };
    EXPECT_GT(contrast(across), 0.01) << wind_deg;
    EXPECT_GT(contrast(across), 1.5 * contrast(along)) << wind_deg;
    const std::vector<float> here = look(points(), 0.1f, 0.0f, across).lit;
    const auto change = [&](const vec3& step) {
      return difference(here, look(points(step), 0.1f, 0.0f, across).lit);
    };
    const double x = change({5.0f, 0.0f, 0.0f}), z = change({0.0f, 0.0f, 5.0f});
    EXPECT_GT(is_along_z ? x / z : z / x, 1.5) << wind_deg;
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
