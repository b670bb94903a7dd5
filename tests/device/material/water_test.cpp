// Tests the transmittance of water in closed form and at its limits.
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

class Water : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};

  AeroScene scene() const {
    AeroScene scene = bare_scene();
    scene.water = {{0.35f, 0.06f, 0.015f}, {0.01f, 0.08f, 0.12f}, {0.6f, 0.5f, 0.4f}, 0, 6, 0.1f};
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
            normals, roughness);
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

AEROSTAT_AT_EVERY_WIDTH(Water);

}  // namespace
}  // namespace aerostat::test
