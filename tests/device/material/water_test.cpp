// Tests what water mirrors and lets through, in closed form and at its limits.
#include <algorithm>
#include <cmath>
#include <random>

#include "shading_scene.hpp"

namespace aerostat::test {
namespace {

/// Returns the reflectance of water of index 1.333 for unpolarised light, by Fresnel's equations.
float exact_reflectance(float cosine) {
  constexpr float kIndex = 1.333f;
  const float inside = std::sqrt(1.0f - (1.0f - cosine * cosine) / (kIndex * kIndex));
  const float across = (cosine - kIndex * inside) / (cosine + kIndex * inside);
  const float along = (kIndex * cosine - inside) / (kIndex * cosine + inside);
  return 0.5f * (across * across + along * along);
}

/// Returns Schlick's approximation of exact_reflectance().
double schlick(double cosine) {
  return 0.0204 + (1.0 - 0.0204) * std::pow(1.0 - cosine, 5.0);
}

/// Returns the mean of schlick() over waves whose slopes are distributed normally with a variance
/// of `variance` along both axes together. Each slope counts by the area that a viewer at `cosine`
/// sees.
double mean_over_waves(double cosine, double variance) {
  constexpr int kParts = 80;
  constexpr double kReach = 4.0;  // standard deviations
  const double deviation = std::sqrt(0.5 * variance), sine = std::sqrt(1.0 - cosine * cosine);
  double sum = 0.0, weights = 0.0;
  for (int i = 0; i < kParts; ++i) {
    for (int j = 0; j < kParts; ++j) {
      const double x = kReach * (2.0 * (i + 0.5) / kParts - 1.0);
      const double z = kReach * (2.0 * (j + 0.5) / kParts - 1.0);
      const double seen = cosine - deviation * x * sine;
      if (seen <= 0.0) continue;
      const double weight = std::exp(-0.5 * (x * x + z * z)) * seen;
      sum += weight * schlick(seen / std::sqrt(1.0 + deviation * deviation * (x * x + z * z)));
      weights += weight;
    }
  }
  return sum / weights;
}

class Water : public LaneTest {
 protected:
  const Probe probe{"water.cl", GetParam()};

  AeroScene scene() const {
    AeroScene scene = bare_scene();
    scene.water = {
        {0.35f, 0.06f, 0.015f}, {0.01f, 0.08f, 0.12f}, {0.6f, 0.5f, 0.4f}, 0, 6, 0.1f, 0};
    scene.ground.wind[0] = 1.0f;
    return scene;
  }

  std::vector<vec3> body(const std::vector<float>& depths, float cosine, const vec3& light) const {
    const std::size_t count = whole_packets(depths.size());
    const std::vector<float> cosines(count, cosine);
    const auto radiance = output<float>(3 * count);
    probe.run("probe_water", count, uploaded(scene()), input(padded(depths)), input(cosines),
              input(planes(std::vector<vec3>(count, light))), radiance);
    const auto values = radiance.read();
    std::vector<vec3> result;
    for (std::size_t i = 0; i < depths.size(); ++i) result.push_back(from_planes(values, i));
    return result;
  }
};

TEST_P(Water, ReflectsAsFresnelSays) {
  std::vector<float> cosines;
  for (int i = 0; i < 64; ++i) cosines.push_back(static_cast<float>(i) / 63.0f);
  const auto reflectance = output<float>(cosines.size());
  probe.run("probe_fresnel", cosines.size(), input(cosines), reflectance);
  const auto shares = reflectance.read();
  EXPECT_NEAR(shares.back(), 0.0204f, 1e-6f) << "straight down";
  EXPECT_NEAR(shares.front(), 1.0f, 1e-6f) << "grazing";
  for (std::size_t i = 1; i < shares.size(); ++i) EXPECT_LT(shares[i], shares[i - 1] + 1e-7f);
  // Schlick's approximation is off by at most 0.0592 for water, by 0.0167 above a cosine of 0.3 and
  // by 0.0093 above 0.5.
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const float tolerance = cosines[i] < 0.3f ? 0.06f : cosines[i] < 0.5f ? 0.017f : 0.0095f;
    EXPECT_NEAR(shares[i], exact_reflectance(cosines[i]), tolerance) << cosines[i];
  }
}

TEST_P(Water, RefractsAsSnellSays) {
  std::mt19937 random(7);
  std::normal_distribution<float> slope(0.0f, 0.1f);
  std::uniform_real_distribution<float> height(0.5f, 1.0f);
  constexpr std::size_t kRays = 256;
  std::vector<vec3> normals(kRays), to_viewer(kRays);
  for (std::size_t i = 0; i < kRays; ++i) {
    normals[i] = glm::normalize(vec3(slope(random), 1.0f, slope(random)));
    const float up = height(random);
    to_viewer[i] = {std::sqrt(1.0f - up * up), up, 0.0f};
  }
  const auto ways = output<float>(3 * kRays);
  probe.run("probe_way_below_waves", kRays, input(planes(normals)), input(planes(to_viewer)), ways);
  const auto values = ways.read();
  for (std::size_t i = 0; i < kRays; ++i) {
    const vec3 way = from_planes(values, i);
    ASSERT_NEAR(way.y, -1.0f, 1e-5f) << "a metre of depth";
    // The law of refraction for vectors: what lies across the normal shrinks by the index.
    const vec3 below = glm::normalize(way), above = -to_viewer[i];
    const vec3 bent = 1.333f * glm::cross(normals[i], below) - glm::cross(normals[i], above);
    ASSERT_LT(glm::length(bent), 2e-5f) << i;
  }
}

// The formula is a fit. It is off by at most 0.03 for these waves, which become rough enough to
// halve what water mirrors at a slant.
TEST_P(Water, ReflectsWhatItsUnresolvedWavesDoOnAverage) {
  const std::vector<float> cosines = padded({0.02f, 0.05f, 0.1f, 0.2f, 0.3f, 0.5f, 0.7f, 1.0f});
  for (const float variance : {1e-6f, 0.003f, 0.01f, 0.03f, 0.06f}) {
    const auto reflectance = output<float>(cosines.size());
    probe.run("probe_rough_fresnel", cosines.size(), input(cosines), variance, reflectance);
    const auto shares = reflectance.read();
    for (std::size_t i = 0; i < 8; ++i) {
      const double expected =
          mean_over_waves(static_cast<double>(cosines[i]), static_cast<double>(variance));
      EXPECT_NEAR(shares[i], expected, 0.035) << cosines[i] << ", variance " << variance;
    }
  }
}

/// Returns points all over a sea.
std::vector<vec3> anywhere(std::size_t count) {
  std::mt19937 random(53);
  std::uniform_real_distribution<float> coordinate(-2000.0f, 2000.0f);
  std::vector<vec3> points(count);
  for (vec3& p : points) {
    const float x = coordinate(random);
    p = {x, 0.0f, coordinate(random)};
  }
  return points;
}

// The bed is sand of uneven brightness near the shore and in deep water. Between them weed darkens
// parts of it.
TEST_P(Water, HasWeedOnItsBedBetweenTheShoreAndTheDeep) {
  constexpr std::size_t kPoints = 2048;
  const vec3 sand(0.6f, 0.5f, 0.4f);
  for (const float depth : {0.5f, 5.0f, 20.0f}) {
    const auto albedo = output<float>(3 * kPoints);
    probe.run("probe_bed", kPoints, uploaded(scene()), input(planes(anywhere(kPoints))),
              input(std::vector<float>(kPoints, depth)), 0.02f, albedo);
    const auto values = albedo.read();
    std::size_t dark = 0;
    for (std::size_t i = 0; i < kPoints; ++i) {
      const vec3 share = from_planes(values, i) / sand;
      ASSERT_GT(share.x, 0.15f) << depth;
      ASSERT_LT(share.x, 1.16f) << depth;
      dark += share.x < 0.7f ? 1 : 0;
      if (depth == 5.0f) continue;
      ASSERT_NEAR(share.x, share.y, 1e-5f) << depth;
      ASSERT_NEAR(share.x, share.z, 1e-5f) << depth;
    }
    if (depth == 5.0f) {
      EXPECT_GT(dark, kPoints / 20);
      EXPECT_LT(dark, kPoints / 2);
    } else {
      EXPECT_EQ(dark, 0u) << depth;
    }
  }
}

// There is no foam just above the depth below which it is not looked for, so that no line shows
// there.
TEST_P(Water, FoamsAtTheShoreAndLessWhereItIsDeeper) {
  constexpr std::size_t kPoints = 4096;
  const std::vector<vec3> points = anywhere(kPoints);
  const auto mean_at = [&](float depth) {
    const auto found = output<float>(kPoints);
    probe.run("probe_foam", kPoints, input(planes(points)),
              input(std::vector<float>(kPoints, depth)), 0.02f, found);
    double mean = 0.0;
    for (const float share : found.read()) {
      EXPECT_GE(share, 0.0f);
      EXPECT_LE(share, 1.0f);
      mean += static_cast<double>(share) / kPoints;
    }
    return mean;
  };
  const double shore = mean_at(0.05f), crests = mean_at(1.15f);
  EXPECT_GT(shore, 0.3);
  EXPECT_LT(shore, 0.85);
  EXPECT_GT(crests, 0.01);
  EXPECT_LT(crests, 0.5 * shore);
  EXPECT_EQ(mean_at(2.4f), 0.0);
  EXPECT_EQ(mean_at(2.6f), 0.0);
}

TEST_P(Water, ShowsItsBedWhereShallowAndItselfWhereDeep) {
  const vec3 light(2.0f, 1.0f, 0.5f);
  const auto radiance = body({0.0f, 1e-4f, 3.0f, 2000.0f, 1e5f}, 1.0f, light);
  EXPECT_LT(glm::distance(radiance[0], light * vec3(0.6f, 0.5f, 0.4f)), 1e-6f);
  EXPECT_LT(glm::distance(radiance[1], radiance[0]), 1e-3f);
  EXPECT_LT(glm::distance(radiance[3], light * vec3(0.01f, 0.08f, 0.12f)), 1e-6f);
  EXPECT_LT(glm::distance(radiance[4], light * vec3(0.01f, 0.08f, 0.12f)), 1e-6f);
  // Red is absorbed first and blue last.
  const vec3 deep(0.01f, 0.08f, 0.12f), bed(0.6f, 0.5f, 0.4f);
  const vec3 through = (radiance[2] / light - deep) / (bed - deep);
  const float path = 3.0f * 2.15f;
  EXPECT_NEAR(through.x, std::exp(-0.35f * path), 1e-5f);
  EXPECT_NEAR(through.y, std::exp(-0.06f * path), 1e-5f);
  EXPECT_NEAR(through.z, std::exp(-0.015f * path), 1e-5f);
}

TEST_P(Water, IsDarkerOnASlantWithoutBound) {
  const vec3 down = body({2.0f}, 1.0f, vec3(1.0f))[0], slant = body({2.0f}, 0.02f, vec3(1.0f))[0];
  EXPECT_LT(slant.x, down.x);
  EXPECT_GT(slant.z, 0.3f);
}

TEST_P(Water, WavesFlattenWithDistanceAndTheirSlopeTurnsToRoughness) {
  std::mt19937 random(91);
  std::uniform_real_distribution<float> coordinate(-500.0f, 500.0f);
  const std::size_t count = 256;
  std::vector<vec3> positions(count);
  std::vector<float> footprints(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float x = coordinate(random);
    positions[i] = {x, 0.0f, coordinate(random)};
    footprints[i] = i < count / 2 ? 0.01f : 100.0f;
  }
  const auto normals = output<float>(3 * count), roughness = output<float>(count);
  probe.run("probe_waves", count, uploaded(scene()), input(planes(positions)), input(footprints),
            0.0f, normals, roughness);
  const auto n = normals.read(), rough = roughness.read();
  float steepest = 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const vec3 normal = from_planes(n, i);
    ASSERT_NEAR(glm::length(normal), 1.0f, 1e-6f);
    ASSERT_GT(normal.y, 0.3f);
    if (i >= count / 2) {
      ASSERT_EQ(normal, vec3(0, 1, 0));
    }
    steepest = std::max(steepest, std::hypot(normal.x, normal.z));
  }
  EXPECT_GT(steepest, 0.02f);
  EXPECT_LT(rough[0], rough[count - 1]);
}

// Three of the eight octaves are missing inland, 0.3 of the variance of slope, and 0.16 of the rest
// is left. Gusts are the same.
TEST_P(Water, LakesHaveSmallerWavesThanTheSea) {
  constexpr std::size_t kPoints = 256;
  const auto positions = input(planes(anywhere(kPoints)));
  const auto roughness_at = [&](float footprint, float inland) {
    const auto normals = output<float>(3 * kPoints), roughness = output<float>(kPoints);
    probe.run("probe_waves", kPoints, uploaded(scene()), positions,
              input(std::vector<float>(kPoints, footprint)), inland, normals, roughness);
    return roughness.read();
  };
  const auto sea = roughness_at(100.0f, 0.0f), lake = roughness_at(100.0f, 1.0f);
  for (std::size_t i = 0; i < kPoints; ++i) {
    ASSERT_NEAR(lake[i], 0.16f * 0.7f * sea[i], 1e-3f * sea[i]);
  }
}

AEROSTAT_AT_EVERY_WIDTH(Water);

}  // namespace
}  // namespace aerostat::test
