// Tests the transmittance and the places of cumulus clouds.
#include "rules/cumulus.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "clouds.hpp"

namespace aerostat::test {
namespace {

constexpr float kBase = 1000.0f, kThickness = 800.0f, kExtinction = 1e-3f;

/// Returns a scene with a deck without gaps. A footprint of 20 m does not resolve its bulges.
pack::PackedScene closed_deck() {
  AeroScene scene = bare_scene();
  scene.sky.cumulus = {kBase, kThickness, 10.0f, -1e6f, kExtinction, 7u, {}, 0.0f, {}};
  return with_even_sky(scene);
}

class Cumulus : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};

  std::vector<float> shadow(const pack::PackedScene& scene, const std::vector<vec3>& positions,
                            float footprint) const {
    const std::size_t count = whole_packets(positions.size());
    const auto share = output<float>(count);
    const UploadedScene on_device(scene);
    probe.run("probe_cloud_shadow", count, on_device.numbers, on_device.sky_table,
              on_device.cloud_chart, input(planes(positions)),
              input(std::vector<float>(count, footprint)), share);
    auto values = share.read();
    values.resize(positions.size());
    return values;
  }

  std::vector<float> density(const pack::PackedScene& scene, const std::vector<vec3>& positions,
                             const std::vector<float>& footprints) const {
    const std::size_t count = whole_packets(positions.size());
    const auto found = output<float>(count);
    const UploadedScene on_device(scene);
    probe.run("probe_cloud_density", count, on_device.numbers, on_device.sky_table,
              on_device.cloud_chart, input(planes(positions)), input(padded(footprints)), found);
    auto values = found.read();
    values.resize(positions.size());
    return values;
  }

  std::vector<float> density(const pack::PackedScene& scene, const std::vector<vec3>& positions,
                             float footprint) const {
    return density(scene, positions, std::vector<float>(positions.size(), footprint));
  }

  /// Returns the optical depth from `from` on along a ray through all of the layer: the sum of the
  /// density at many points. `footprint` returns the footprint at a distance.
  template <typename Footprint>
  double depth_along(const pack::PackedScene& scene, const vec3& from, const vec3& direction,
                     Footprint footprint) const {
    constexpr int kPoints = 4096;
    const double length = 2.5 * static_cast<double>(kThickness / direction.y);
    const double start = static_cast<double>((kBase - from.y) / direction.y) - 0.25 * length;
    std::vector<vec3> points;
    std::vector<float> footprints;
    for (int i = 0; i < kPoints; ++i) {
      const auto t = static_cast<float>(std::max(start, 0.0) + length * (i + 0.5) / kPoints);
      points.push_back(from + t * direction);
      footprints.push_back(footprint(t));
    }
    double sum = 0.0;
    for (const float found : density(scene, points, footprints)) sum += static_cast<double>(found);
    return static_cast<double>(scene.numbers.sky.cumulus.extinction) * length * sum / kPoints;
  }

  /// Returns the share of white light that is left along rays to the sky, as `left` does, by fine
  /// steps.
  std::vector<float> left_finely(const pack::PackedScene& scene,
                                 const std::vector<vec3>& directions, float height) const {
    const std::size_t count = whole_packets(directions.size());
    const auto arriving = output<float>(3 * count);
    const UploadedScene on_device(scene);
    probe.run("probe_clouds_finely", count, on_device.numbers, on_device.sky_table,
              on_device.cloud_chart,
              input(planes(std::vector<vec3>(directions.size(), {0.0f, height, 0.0f}))),
              input(planes(directions)), 4.0f, arriving);
    auto values = arriving.read();
    values.resize(directions.size());
    return values;
  }

  /// Returns the share of white light that is left along rays from (0, height, 0), with what the
  /// clouds add to it. `behind` is the radiance of that light. `shift` is that of march_clouds().
  std::vector<float> left(const pack::PackedScene& scene, const std::vector<vec3>& directions,
                          float height, float distance, float behind = 1.0f,
                          float shift = 0.5f) const {
    const std::size_t count = whole_packets(directions.size());
    const auto arriving = output<float>(3 * count);
    const UploadedScene on_device(scene);
    probe.run("probe_clouds", count, on_device.numbers, on_device.sky_table, on_device.cloud_chart,
              input(planes(std::vector<vec3>(directions.size(), {0.0f, height, 0.0f}))),
              input(planes(directions)), input(std::vector<float>(count, distance)), behind, shift,
              arriving);
    const auto values = arriving.read();
    std::vector<float> result;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      result.push_back(from_planes(values, i).x);
    }
    return result;
  }
};

/// Tests the bound by which the host charts where there is no cloud.
TEST(CumulusTowers, ReachTheLowestDensityAtTheLeastExcess) {
  EXPECT_FLOAT_EQ(rules::cumulus_towers(CUMULUS_LEAST_EXCESS), CUMULUS_LOWEST);
  EXPECT_LT(rules::cumulus_towers(CUMULUS_LEAST_EXCESS - 1e-4f), CUMULUS_LOWEST);
  EXPECT_EQ(rules::cumulus_bulging(CUMULUS_LEAST_EXCESS), 0.0f);
}

TEST(CumulusTowers, ReachTheHeightWhoseExcessIsAskedFor) {
  for (const float height : {-0.3f, -0.1f, 0.0f, 0.05f, 0.4f, 0.9f}) {
    EXPECT_NEAR(rules::cumulus_towers(rules::cumulus_excess_of(height)), height, 1e-5f);
  }
}

// Rays step by the excess that clouds need at least at a height, over points that have less.
TEST(CumulusTowers, NeedTheExcessThatTheirBulgesLeave) {
  for (float height = CUMULUS_LOWEST; height < CUMULUS_TALLEST; height += 0.01f) {
    const float needed = rules::cumulus_needed(height);
    for (float excess = -0.3f; excess < needed; excess += 0.01f) {
      const float bulge = rules::cumulus_bulging(excess);
      const float tower =
          rules::cumulus_towers(excess + bulge * CUMULUS_BULGE) + bulge * CUMULUS_LIFT;
      EXPECT_LE(tower, height + 1e-5f) << excess;
    }
  }
}

TEST(TallClouds, AreNoColumns) {
  auto scene = scene::defaults(scene::BiomeKind::tropical, scene::View::outside);
  const float usual = static_cast<float>(scene.sky.cumulus.thickness_m);
  EXPECT_EQ(pack::pack_scene(resolved(scene)).numbers.sky.cumulus.thickness, usual);
  scene.sky.cumulus.thickness_m = 6000.0;
  scene.sky.cumulus.size_m = 50.0;
  EXPECT_EQ(pack::pack_scene(resolved(scene)).numbers.sky.cumulus.thickness, 75.0f);
}

// The narrow peak of the droplets' phase function, which takes half of the light, deflects it by
// hardly more than the sun's disc. The light that it deflects still comes from the sun, and all
// other light that droplets deflect is the cloud's own.
TEST_P(Cumulus, DimsTheSunByWhatDropletsDeflectWidely) {
  constexpr double kWide = 0.494;  // droplets of 16 micrometres
  const vec3 point(5.0f, 0.0f, 9.0f);
  for (const float extinction : {1e-4f, 1e-3f, 3e-3f, 1e-2f}) {
    for (const float degrees : {0.0f, 40.0f, 60.0f}) {
      pack::PackedScene scene = closed_deck();
      scene.numbers.sky.cumulus.extinction = extinction;
      set3(scene.numbers.sky.sun_direction, tilted(degrees));
      // The depth depends a little on the footprint, which is between these two.
      const double fine = depth_along(scene, point, tilted(degrees), [](float) { return 20.0f; });
      const double coarse =
          depth_along(scene, point, tilted(degrees), [](float) { return 150.0f; });
      const double share = static_cast<double>(shadow(scene, {point}, 20.0f)[0]);
      EXPECT_GT(share, 0.99 * std::exp(-kWide * std::max(fine, coarse))) << extinction;
      EXPECT_LT(share, 1.01 * std::exp(-kWide * std::min(fine, coarse))) << extinction;
    }
  }
}

// A slanted way through the deck is longer, as if the deck was denser.
TEST_P(Cumulus, DimsASlantedSunAsADenserDeckDims) {
  const vec3 point(5.0f, 0.0f, 9.0f);
  for (const float degrees : {20.0f, 35.0f, 50.0f}) {
    pack::PackedScene slanted = closed_deck(), denser = closed_deck();
    set3(slanted.numbers.sky.sun_direction, tilted(degrees));
    denser.numbers.sky.cumulus.extinction /= tilted(degrees).y;
    const float expected = shadow(denser, {point}, 20.0f)[0];
    EXPECT_NEAR(shadow(slanted, {point}, 20.0f)[0], expected, 0.03f * expected) << degrees;
  }
}

TEST_P(Cumulus, HidesByBeersLaw) {
  pack::PackedScene scene = closed_deck();
  set3(scene.numbers.sky.sun_irradiance, vec3(0.0f));
  const std::vector<float> angles{0.0f, 30.0f, 55.0f};
  const auto through = left(scene, {tilted(0.0f), tilted(30.0f), tilted(55.0f)}, 900.0f, INFINITY);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    // The probe's pixels are 0.05 wide.
    const double depth = depth_along(scene, {0.0f, 900.0f, 0.0f}, tilted(angles[i]),
                                     [](float t) { return 0.05f * t; });
    const double expected = std::exp(-depth);
    EXPECT_NEAR(through[i], expected, 0.03 * expected) << angles[i];
  }
  EXPECT_EQ(left(scene, {tilted(0.0f)}, 0.0f, 890.0f)[0], 1.0f) << "what stands below the clouds";
  EXPECT_EQ(left(scene, {tilted(180.0f)}, 900.0f, INFINITY)[0], 1.0f) << "downwards from below";
  EXPECT_EQ(left(scene, {tilted(10.0f)}, 2100.0f, INFINITY)[0], 1.0f) << "upwards from above";
  EXPECT_LT(left(scene, {tilted(180.0f)}, 2100.0f, 2100.0f)[0], 0.7f) << "the ground from above";
}

// In even light from all sides, a cloud that absorbs nothing cannot be seen.
TEST_P(Cumulus, VanishInEvenLight) {
  pack::PackedScene scene = closed_deck();
  scene.numbers.sky.cumulus.extinction = 0.03f;
  scene.numbers.air.sun_heights[0] = 1e8f;  // the sun is far below the horizon
  scene.numbers.air.sun_heights[1] = 2e8f;
  set3(scene.numbers.sky.sun_irradiance, vec3(1.0f));
  set_ambient(scene.numbers, vec3(1.0f), vec3(1.0f));
  for (const float light :
       left(scene, {tilted(0.0f), tilted(40.0f), tilted(70.0f)}, 0.0f, INFINITY)) {
    EXPECT_NEAR(light, 1.0f, 1e-4f);
  }
}

TEST_P(Cumulus, CastsTheSameShadowAllAlongTheSunsRay) {
  pack::PackedScene scene = broken_clouds(0.4);
  set3(scene.numbers.sky.sun_direction, tilted(50.0f));
  std::mt19937 random(17);
  std::uniform_real_distribution<float> coordinate(-20000.0f, 20000.0f);
  std::vector<vec3> low(256), high(256);
  for (std::size_t i = 0; i < low.size(); ++i) {
    low[i] = {coordinate(random), 0.0f, coordinate(random)};
    high[i] = low[i] + 700.0f * tilted(50.0f);
  }
  // The sun's penumbra is narrower than this footprint at both heights.
  const auto below = shadow(scene, low, 60.0f), above = shadow(scene, high, 60.0f);
  int shaded = 0;
  for (std::size_t i = 0; i < low.size(); ++i) {
    EXPECT_NEAR(below[i], above[i], 2e-3f) << i;
    shaded += below[i] < 0.5f ? 1 : 0;
  }
  EXPECT_GT(shaded, 20);
  EXPECT_LT(shaded, 236);
}

TEST_P(Cumulus, CoversTheShareOfTheSkyThatIsAskedFor) {
  std::mt19937 random(23);
  std::uniform_real_distribution<float> coordinate(-1e5f, 1e5f);
  std::vector<vec3> points(4096);
  for (vec3& p : points) p = {coordinate(random), 0.0f, coordinate(random)};
  for (const double cover : {0.0, 0.1, 0.3, 0.6, 1.0}) {
    const auto shares = shadow(broken_clouds(cover), points, 1.0f);
    double shaded = 0.0;
    for (const float share : shares) {
      ASSERT_GE(share, 0.0f);
      ASSERT_LE(share, 1.0f);
      shaded += share < 0.6f ? 1.0 : 0.0;
    }
    EXPECT_NEAR(shaded / 4096.0, cover, 0.09) << cover;
  }
}

/// Returns points around the eye at all heights of the layer. Some of them are beyond the chart.
std::vector<vec3> points_among(const pack::PackedScene& scene, std::size_t count) {
  const AeroCumulus& clouds = scene.numbers.sky.cumulus;
  const AeroCloudChart& chart = clouds.chart;
  const float side = static_cast<float>(chart.side) * chart.cell;
  std::mt19937 random(31);
  std::uniform_real_distribution<float> share(-0.02f, 1.02f), height(-0.1f, 1.2f);
  std::vector<vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = chart.x0 + share(random) * side, z = chart.z0 + share(random) * side;
    points.push_back({x, clouds.base + height(random) * clouds.thickness, z});
  }
  return points;
}

pack::PackedScene without_chart(pack::PackedScene scene) {
  scene.numbers.sky.cumulus.chart.side = 0u;
  scene.cloud_chart = nullptr;
  return scene;
}

// Tests that there is no cloud where the chart says so, because density is not evaluated there.
TEST_P(Cumulus, ChartHidesNoCloud) {
  for (const double cover : {0.05, 0.3}) {
    const pack::PackedScene scene = broken_clouds(cover);
    ASSERT_EQ(scene.numbers.sky.cumulus.chart.side, std::uint32_t{AERO_CHART_SIDE});
    const std::vector<vec3> points = points_among(scene, 60000);
    for (const float footprint : {0.5f, 30.0f, 120.0f}) {
      const auto charted = density(scene, points, footprint);
      const auto asked = density(without_chart(scene), points, footprint);
      std::size_t cloudy = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_EQ(charted[i], asked[i]) << i << ' ' << cover << ' ' << footprint;
        cloudy += asked[i] > 0.0f ? 1 : 0;
      }
      EXPECT_GT(cloudy, 500u);
    }
    const auto shade = shadow(scene, points, 5.0f);
    EXPECT_EQ(shade, shadow(without_chart(scene), points, 5.0f));
  }
}

/// Returns directions well above the horizon.
std::vector<vec3> directions_to_clouds(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> azimuth(0.0f, 6.2831853f), elevation(0.15f, 0.9f);
  std::vector<vec3> directions(count);
  for (vec3& d : directions) {
    const float a = azimuth(random), up = elevation(random);
    d = {std::cos(a) * std::cos(up), std::sin(up), std::sin(a) * std::cos(up)};
  }
  return directions;
}

// Tests the march, which leaps, steps and lights in three places, against small even steps, which
// take a thousand times as long.
TEST_P(Cumulus, MarchSeesWhatSmallStepsSee) {
  pack::PackedScene scene = broken_clouds(0.3);
  set3(scene.numbers.sky.sun_direction, tilted(60.0f));
  const auto directions = directions_to_clouds(768, 41);
  const auto fine = left_finely(scene, directions, 2.0f);
  for (const pack::PackedScene& asked : {scene, without_chart(scene)}) {
    const auto seen = left(asked, directions, 2.0f, INFINITY);
    double mean = 0.0, difference = 0.0, squared = 0.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double error = double{seen[i]} - double{fine[i]};
      mean += error / 768.0;
      difference += std::abs(error) / 768.0;
      squared += error * error / 768.0;
    }
    EXPECT_LT(std::abs(mean), 0.003);
    EXPECT_LT(difference, 0.01);
    EXPECT_LT(std::sqrt(squared), 0.03);
  }
}

// Clouds have no contours within them: along an arc over the sky, the mean over samples changes
// little between directions that are a thousandth of a degree apart.
TEST_P(Cumulus, SamplesTogetherShowNoContours) {
  pack::PackedScene scene = broken_clouds(0.3);
  set3(scene.numbers.sky.sun_direction, tilted(60.0f));
  std::vector<vec3> arc(16384);
  for (std::size_t i = 0; i < arc.size(); ++i) {
    const float azimuth = 2e-5f * static_cast<float>(i);
    arc[i] = {std::cos(azimuth) * std::cos(0.3f), std::sin(0.3f),
              std::sin(azimuth) * std::cos(0.3f)};
  }
  constexpr int kSamples = 16;
  std::vector<double> means(arc.size());
  for (int k = 0; k < kSamples; ++k) {
    const float shift = (static_cast<float>(k) + 0.5f) / kSamples;
    const auto seen = left(scene, arc, 2.0f, INFINITY, 1.0f, shift);
    for (std::size_t i = 0; i < arc.size(); ++i) means[i] += double{seen[i]} / kSamples;
  }
  double largest = 0.0, least = 1.0, most = 0.0;
  for (std::size_t i = 1; i < arc.size(); ++i) {
    largest = std::max(largest, std::abs(means[i] - means[i - 1]));
    least = std::min(least, means[i]);
    most = std::max(most, means[i]);
  }
  EXPECT_LT(largest, 0.01);
  EXPECT_GT(most - least, 0.2) << "the arc crosses clouds";
}

// The sun's disc is a hundred thousand times as bright as the sky.
TEST_P(Cumulus, ThickCloudsLeaveNothingOfTheSun) {
  const std::vector<vec3> up{tilted(0.0f), tilted(40.0f), tilted(70.0f)};
  pack::PackedScene scene = closed_deck();
  scene.numbers.sky.cumulus.extinction = 0.05f;
  for (const float light : left(scene, up, 0.0f, INFINITY, 1e5f)) EXPECT_LT(light, 10.0f);
  // Thin clouds leave what they do not hide.
  scene.numbers.sky.cumulus.extinction = 1e-4f;
  for (const float light : left(scene, up, 0.0f, INFINITY, 1e5f)) EXPECT_GT(light, 5e4f);
}

TEST_P(Cumulus, LeavesNumbersInEveryDirection) {
  const pack::PackedScene scene = broken_clouds(0.5);
  std::mt19937 random(5);
  std::normal_distribution<float> normal;
  std::vector<vec3> directions(512);
  for (vec3& d : directions) {
    d = glm::normalize(vec3(normal(random), 0.1f * normal(random), normal(random)));
  }
  for (const float height : {2.0f, 1300.0f, 5000.0f}) {
    for (const float light : left(scene, directions, height, INFINITY)) {
      ASSERT_TRUE(std::isfinite(light) && light >= 0.0f) << height;
    }
  }
}

AEROSTAT_AT_EVERY_WIDTH(Cumulus);

}  // namespace
}  // namespace aerostat::test
