// How lights are sampled, where the answer is known in closed form.
#include <algorithm>
#include <cmath>
#include <random>

#include "shading_scene.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kSamples = 1u << 15;
constexpr std::uint32_t kSun = 0;

struct Sampled {
  std::vector<vec3> directions, strengths;
  std::vector<float> distances, densities;
};

class Lights : public LaneTest {
 protected:
  const Probe probe{"lights.cl", GetParam()};

  Sampled sample(const pack::PackedScene& scene, std::uint32_t light, const vec3& position,
                 const vec3& normal) const {
    std::mt19937 random(23);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<vec3> numbers;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const float u = unit(random), v = unit(random);
      numbers.emplace_back(std::min(u, 0.9999999f), v, unit(random));
    }
    const auto directions = output<float>(3 * kSamples), strengths = output<float>(3 * kSamples);
    const auto distances = output<float>(kSamples), densities = output<float>(kSamples);
    const UploadedScene on_device(scene);
    probe.run("probe_light", kSamples, on_device.numbers, on_device.sky_table,
              on_device.cloud_chart, light, input(planes(std::vector<vec3>(kSamples, position))),
              input(planes(std::vector<vec3>(kSamples, normal))), input(planes(numbers)),
              directions, distances, strengths, densities);
    Sampled result;
    const auto d = directions.read(), s = strengths.read();
    for (std::size_t i = 0; i < kSamples; ++i) {
      result.directions.push_back(from_planes(d, i));
      result.strengths.push_back(from_planes(s, i));
    }
    result.distances = distances.read();
    result.densities = densities.read();
    return result;
  }
};

/// Solid angle of the directions whose cosine with an axis is more.
double cap(double cosine) {
  return 2.0 * std::numbers::pi * (1.0 - cosine);
}

/// The mean of 1 / density over the choices within a cap is its solid angle.
double measured_cap(const Sampled& sampled, const vec3& axis, double cosine) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    if (static_cast<double>(glm::dot(sampled.directions[i], axis)) <= cosine) continue;
    sum += 1.0 / static_cast<double>(sampled.densities[i]);
  }
  return sum / static_cast<double>(kSamples);
}

// Far wider than the sun, so that the density is not the same all over the disc.
TEST_P(Lights, TheSunIsADiscOfItsSize) {
  constexpr float kSpread = 0.8f;
  AeroScene scene = bare_scene();
  const vec3 axis = glm::normalize(vec3(0.3f, 0.7f, -0.5f));
  set3(scene.sky.sun_direction, axis);
  scene.sky.sun_spread = kSpread;
  const Sampled sampled = sample(with_even_sky(scene), kSun, vec3(0.0f), {0, 1, 0});
  const double rim = 1.0 / std::sqrt(1.0 + static_cast<double>(kSpread * kSpread));
  for (std::size_t i = 0; i < kSamples; ++i) {
    ASSERT_GE(static_cast<double>(glm::dot(sampled.directions[i], axis)), rim - 1e-5);
    ASSERT_TRUE(std::isinf(sampled.distances[i]));
    ASSERT_NEAR(sampled.strengths[i].x, 1.0f, 1e-5f) << "irradiance / pi";
  }
  for (const double cosine : {rim - 1e-3, 0.85, 0.95}) {
    const double expected = cap(std::max(cosine, rim));
    EXPECT_NEAR(measured_cap(sampled, axis, cosine), expected, 0.03 * expected) << cosine;
  }
}

TEST_P(Lights, AHardSunHasOneDirection) {
  const AeroScene scene = bare_scene();
  const Sampled sampled = sample(with_even_sky(scene), kSun, vec3(0.0f), {0, 1, 0});
  for (std::size_t i = 0; i < kSamples; ++i) {
    ASSERT_EQ(sampled.directions[i], vec3(0, 1, 0));
    ASSERT_EQ(sampled.densities[i], 0.0f) << "no other choice finds it";
  }
}

TEST_P(Lights, PointLightsFallOffWithTheSquareOfTheDistance) {
  AeroScene scene = bare_scene();
  scene.light_count = 1;
  set3(scene.lights[0].position, {3, 4, 12});
  set3(scene.lights[0].intensity, vec3(2.0f, 1.0f, 0.5f) * kPi);
  const Sampled sampled = sample(with_even_sky(scene), 1, vec3(0.0f), {0, 1, 0});
  EXPECT_LT(glm::distance(sampled.directions[0], vec3(3, 4, 12) / 13.0f), 1e-6f);
  EXPECT_FLOAT_EQ(sampled.distances[0], 13.0f);
  EXPECT_LT(glm::distance(sampled.strengths[0], vec3(2.0f, 1.0f, 0.5f) / 169.0f), 1e-7f);
  EXPECT_EQ(sampled.densities[0], 0.0f);
}

TEST_P(Lights, TheBurnersAreAPointFromAfar) {
  AeroScene scene = bare_scene();
  scene.balloon_count = 2;
  set3(scene.balloons[1].flame, {0, 5, 0});
  set3(scene.balloons[1].flame_light, {3, 2, 1});
  for (const float distance : {0.5f, 2.0f}) {
    const Sampled sampled = sample(with_even_sky(scene), 2, {0, 5.0f - distance, 0}, {0, 1, 0});
    EXPECT_LT(glm::distance(sampled.directions[0], vec3(0, 1, 0)), 1e-6f);
    EXPECT_FLOAT_EQ(sampled.distances[0], distance);
    const float squared = std::max(distance * distance, 0.36f);
    EXPECT_LT(glm::distance(sampled.strengths[0], vec3(3, 2, 1) / squared), 1e-5f);
  }
}

// A plane in an even sky of radiance L gets the irradiance pi L.
TEST_P(Lights, AnEvenSkyLightsEveryPlaneAlike) {
  const pack::PackedScene scene = with_even_sky(bare_scene(), vec3(0.25f) / kPi);
  for (const vec3& normal : {vec3(0, 1, 0), tilted(70.0f), vec3(0, -1, 0)}) {
    const Sampled sampled = sample(scene, 1, vec3(0.0f), normal);
    double sum = 0.0;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const float cosine = glm::dot(sampled.directions[i], normal);
      ASSERT_GE(cosine, -1e-5f);
      sum += static_cast<double>(sampled.strengths[i].x * cosine);
    }
    EXPECT_NEAR(sum / static_cast<double>(kSamples), 0.25, 1e-4);
    for (const double cosine : {0.2, 0.5, 0.9}) {
      const double expected = cap(cosine);
      EXPECT_NEAR(measured_cap(sampled, normal, cosine), expected, 0.04 * expected) << cosine;
    }
  }
}

AEROSTAT_AT_EVERY_WIDTH(Lights);

}  // namespace
}  // namespace aerostat::test
