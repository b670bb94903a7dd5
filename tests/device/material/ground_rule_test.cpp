// Tests that the host places plants by the same rules by which the device paints the ground.
#include "scatter/ground_rule.hpp"

#include <cmath>
#include <random>

#include "pack/pack_scene.hpp"
#include "probe.hpp"
#include "scene/io.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kPoints = 4096;
constexpr float kFootprint = 1.0f;

class GroundRuleProbe : public LaneTest {
 protected:
  void prepare(scene::BiomeKind kind) {
    scene_ = scene::defaults(kind, scene::View::outside);
    scene_.biome.ground.snow_line_m = 300.0;
    std::mt19937 random(31);
    std::uniform_real_distribution<float> across(-6000.0f, 6000.0f), up(-20.0f, 1200.0f),
        slope(0.5f, 1.0f);
    for (std::size_t i = 0; i < kPoints; ++i) {
      const float shore = i % 4 == 0 ? 0.01f : 1.0f;
      points_.emplace_back(across(random), up(random) * shore, across(random));
      slopes_.push_back(slope(random));
    }
  }

  const Probe probe_{"ground.cl", GetParam()};
  scene::Scene scene_;
  std::vector<vec3> points_;
  std::vector<float> slopes_;
};

TEST_P(GroundRuleProbe, IsTheDevicesRule) {
  for (const auto kind : {scene::BiomeKind::snow, scene::BiomeKind::tropical}) {
    points_.clear();
    slopes_.clear();
    prepare(kind);
    const std::vector<AeroGround> ground{pack::pack_scene(scene_).numbers.ground};
    const auto noises = output<float>(3 * kPoints), mixes = output<float>(4 * kPoints);
    probe_.run("probe_ground", kPoints, input(ground), input(planes(points_)), input(slopes_),
               kFootprint, noises, mixes);
    const auto noise = noises.read(), mix = mixes.read();
    const scatter::GroundRule rule(scene_.biome.ground, scene_.terrain.seed, kFootprint);
    const auto host_noise = rule.noise(points_);
    int unsure = 0, woods = 0, open = 0;
    for (std::size_t i = 0; i < kPoints; ++i) {
      const vec3 device = from_planes(noise, i);
      // Lattice coordinates of about 10^3 are known to 1e-4, and slopes add up over the octaves.
      ASSERT_NEAR(device.x, host_noise[i].broad, 2e-3);
      ASSERT_NEAR(device.y, host_noise[i].fine, 1e-2);
      ASSERT_NEAR(device.z, host_noise[i].rough, 1e-2);
      const scatter::GroundMix host = rule.mix(points_[i], slopes_[i], host_noise[i]);
      EXPECT_EQ(host.forest, rule.forest(points_[i], slopes_[i], host_noise[i]));
      const float differences[4] = {mix[i] - host.rock, mix[kPoints + i] - host.beach,
                                    mix[2 * kPoints + i] - host.snow,
                                    mix[3 * kPoints + i] - host.forest};
      for (const float difference : differences) unsure += std::fabs(difference) > 0.02f ? 1 : 0;
      woods += host.forest > 0.99f ? 1 : 0;
      open += host.forest < 0.01f ? 1 : 0;
    }
    // Borders are steep, so rounding is visible at some of them.
    EXPECT_LT(unsure, 40);
    EXPECT_GT(woods, 100);
    EXPECT_GT(open, 500);
  }
}

TEST_P(GroundRuleProbe, RockHasTheDevicesColour) {
  prepare(scene::BiomeKind::sand);
  const std::vector<AeroGround> ground{pack::pack_scene(scene_).numbers.ground};
  const auto colors = output<float>(3 * kPoints);
  probe_.run("probe_rock", kPoints, input(ground), input(planes(points_)), kFootprint, colors);
  const auto device = colors.read();
  const scatter::GroundRule rule(scene_.biome.ground, scene_.terrain.seed, kFootprint);
  const auto noise = rule.noise(points_);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const vec3 expected = from_planes(device, i), actual = rule.rock_color(points_[i], noise[i]);
    ASSERT_NEAR(glm::distance(actual, expected), 0.0f, 5e-3f) << i;
  }
}

AEROSTAT_AT_EVERY_WIDTH(GroundRuleProbe);

}  // namespace
}  // namespace aerostat::test
