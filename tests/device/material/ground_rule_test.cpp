// Tests that the rules of the ground give the same on the host, where plants stand by them, as on
// the device, which paints the ground by them.
#include "ground/ground_rule.hpp"

#include <random>

#include "ground/ground_numbers.hpp"
#include "probe.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kPoints = 4096;
constexpr float kFootprint = 1.0f;

class GroundRuleProbe : public LaneTest {
 protected:
  /// Fills points, some of them near the sea, the slopes there and the noise of the host.
  void prepare(scene::BiomeKind kind) {
    scene::Scene scene = scene::defaults(kind, scene::View::outside);
    scene.biome.ground.snow_line_m = 300.0;
    ground_ = ground::ground_numbers(scene);
    points_.clear();
    std::mt19937 random(31);
    std::uniform_real_distribution<float> across(-6000.0f, 6000.0f), up(-20.0f, 1200.0f),
        any(0.0f, 1.0f);
    const auto slope = [&] {
      const float tilt = any(random);
      return 1.0f - 0.5f * tilt * tilt;
    };
    for (std::size_t i = 0; i < kPoints; ++i) {
      const float shore = i % 4 == 0 ? 0.005f : 1.0f;
      const float x = across(random), y = up(random) * shore;
      points_.emplace_back(x, y, across(random));
      heights_[i] = y;
      slopes_[i] = slope();
      details_[i] = slope();
    }
    noise_ = ground::GroundRule(ground_, kFootprint).noise(points_);
  }

  opencl::Buffer<AeroGround> uploaded_ground() const {
    return input(std::vector<AeroGround>{ground_});
  }

  const Probe probe_{"ground.cl", GetParam()};
  AeroGround ground_{};
  std::vector<vec3> points_;
  std::vector<float> heights_ = std::vector<float>(kPoints);
  std::vector<float> slopes_ = heights_, details_ = heights_;
  std::vector<ground::GroundNoise> noise_;
};

TEST_P(GroundRuleProbe, NoiseOfTheHostsLoopsIsTheDevices) {
  for (const auto kind : {scene::BiomeKind::snow, scene::BiomeKind::tropical,
                          scene::BiomeKind::sand, scene::BiomeKind::meadow}) {
    prepare(kind);
    const auto noises = output<float>(3 * kPoints);
    probe_.run("probe_ground_noise", kPoints, uploaded_ground(), input(planes(points_)), kFootprint,
               noises);
    const auto noise = noises.read();
    for (std::size_t i = 0; i < kPoints; ++i) {
      const vec3 device = from_planes(noise, i);
      // Lattice coordinates of about 10^3 are known to 1e-4, and slopes add up over the octaves.
      ASSERT_NEAR(device.x, noise_[i].broad, 2e-3);
      ASSERT_NEAR(device.y, noise_[i].fine, 1e-2);
      ASSERT_NEAR(device.z, noise_[i].rough, 1e-2);
    }
  }
}

TEST_P(GroundRuleProbe, MixAndRockAreTheDevices) {
  for (const auto kind :
       {scene::BiomeKind::snow, scene::BiomeKind::tropical, scene::BiomeKind::sand}) {
    prepare(kind);
    std::vector<vec3> values;
    for (const ground::GroundNoise& noise : noise_) {
      values.emplace_back(noise.broad, noise.fine, noise.rough);
    }
    const auto mixes = output<float>(5 * kPoints);
    probe_.run("probe_ground_mix", kPoints, uploaded_ground(), input(heights_), input(slopes_),
               input(details_), input(planes(values)), mixes);
    const auto device = mixes.read();
    int kinds[4] = {};
    for (std::size_t i = 0; i < kPoints; ++i) {
      const auto mix =
          rules::ground_mix(&ground_, heights_[i], slopes_[i], details_[i], &noise_[i]);
      const float shares[4] = {mix.rock, mix.beach, mix.snow, mix.forest};
      for (std::size_t k = 0; k < 4; ++k) {
        // Drivers may round a division by some units, and borders are some twenty times as steep.
        ASSERT_NEAR(device[k * kPoints + i], shares[k], 1e-4f) << i << " of kind " << k;
        kinds[k] += shares[k] > 0.99f ? 1 : 0;
      }
      ASSERT_NEAR(device[4 * kPoints + i], rules::rock_tone(heights_[i], &noise_[i]), 1e-4f) << i;
    }
    EXPECT_GT(kinds[0], 500) << "rock";
    if (kind == scene::BiomeKind::sand) continue;
    EXPECT_GT(kinds[3], 100) << "woods";
    EXPECT_GT(kind == scene::BiomeKind::snow ? kinds[2] : kinds[1], 100) << "snow or beach";
  }
}

TEST_P(GroundRuleProbe, FieldsAreTheDevices) {
  prepare(scene::BiomeKind::meadow);
  std::vector<vec3> values;
  for (const ground::GroundNoise& noise : noise_) {
    values.emplace_back(noise.broad, noise.fine, noise.rough);
  }
  const auto fields = output<float>(3 * kPoints);
  probe_.run("probe_field", kPoints, uploaded_ground(), input(planes(points_)), input(slopes_),
             input(planes(values)), fields);
  const auto device = fields.read();
  const float width = ground_.field_width;
  int at_edge = 0, inside = 0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const vec3& p = points_[i];
    const auto field = rules::field_at(&ground_, p.x, p.z, slopes_[i], &noise_[i]);
    const vec3 found = from_planes(device, i);
    ASSERT_NEAR(found.x, field.share, 1e-4f) << i;
    // Coordinates are known to a millimetre. On an edge, either parcel is right.
    ASSERT_NEAR(found.z, field.edge, 0.01f) << i;
    ASSERT_GE(field.edge, -0.01f);
    ASSERT_LE(field.edge, 0.5f * width + 0.01f);
    if (field.edge > 0.05f) {
      ASSERT_NEAR(found.y, field.crop, 1e-6f) << i;
    }
    at_edge += field.edge < 0.1f * width ? 1 : 0;
    inside += field.share > 0.5f ? 1 : 0;
  }
  // A parcel is 1 by 1.7 widths: 1 - 0.8 * 1.5 / 1.7 = 0.29 of it is so near to an edge.
  EXPECT_NEAR(static_cast<double>(at_edge) / kPoints, 0.294, 0.03);
  EXPECT_GT(inside, 100);
}

/// Tests that what the host asks for single trees is the mix that the ground is painted by where it
/// has no detail.
TEST_P(GroundRuleProbe, PlantsStandByTheMix) {
  prepare(scene::BiomeKind::snow);
  const ground::GroundRule rule(ground_, kFootprint);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const auto mix = rules::ground_mix(&ground_, heights_[i], slopes_[i], slopes_[i], &noise_[i]);
    EXPECT_EQ(rule.forest(points_[i], slopes_[i], noise_[i]), mix.forest);
    EXPECT_EQ(rule.mix(points_[i], slopes_[i], noise_[i]).snow, mix.snow);
    EXPECT_GE(rule.forest_at_most(points_[i], noise_[i]), mix.forest);
  }
}

AEROSTAT_AT_EVERY_WIDTH(GroundRuleProbe);

}  // namespace
}  // namespace aerostat::test
