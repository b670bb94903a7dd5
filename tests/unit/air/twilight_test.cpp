// Tests the sky from sunset into the night in absolute units.

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "air/light.hpp"
#include "scene/io.hpp"
#include "support/resolved.hpp"

namespace aerostat::air {
namespace {

constexpr double kPi64 = std::numbers::pi;
/// The illuminance of the sun outside the air, in lux.
constexpr double kSunLux = 133100.0;

double luminance(const dvec3& c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

SkyTable solve(double sun_deg, scene::BiomeKind biome) {
  auto scene = scene::defaults(biome, scene::View::outside);
  const double e = sun_deg * kPi64 / 180.0;
  scene.sun.direction = {0.0, std::sin(e), -std::cos(e)};
  scene.camera.position = {0.0, 200.0, 0.0};
  return Light(test::resolved(scene)).sky;
}

/// Returns the sky over snow. Each sky is computed once.
const SkyTable& sky_under(double sun_deg) {
  static std::map<double, SkyTable> skies;
  const auto found = skies.find(sun_deg);
  if (found != skies.end()) return found->second;
  return skies.emplace(sun_deg, solve(sun_deg, scene::BiomeKind::snow)).first->second;
}

double lux_under(double sun_deg) {
  return kSunLux * luminance(sky_under(sun_deg).irradiance_from_above());
}

/// Returns the published illuminance in lux under a sun without a moon. Source: P. M. Janiczek and
/// J. A. DeYoung, "Computer Programs for Sun and Moon Illuminance", US Naval Observatory Circular
/// 171, 1987.
double published_lux(double sun_deg) {
  const double x = sun_deg / 90.0;
  const auto cubic = [x](double a, double b, double c, double d) {
    return std::pow(10.0, a + x * (b + x * (c + x * d)));
  };
  if (sun_deg > -5.0) return cubic(2.88, 21.81, -258.11, -858.36);
  if (sun_deg > -12.0) return cubic(2.70, 12.17, -431.69, -1899.83);
  return cubic(13.84, 262.72, 1447.42, 2797.93);
}

TEST(Twilight, GivesThePublishedLight) {
  for (const double sun_deg : {-1.0, -2.0, -4.0, -6.0, -8.0, -10.0, -12.0, -14.0, -16.0, -18.0}) {
    const double lux = lux_under(sun_deg), expected = published_lux(sun_deg);
    // The published light is that of one clear air. Clear airs differ by up to three stops, so a
    // factor of 3.5 either way is allowed.
    EXPECT_LT(lux, 3.5 * expected) << sun_deg;
    EXPECT_GT(lux, expected / 3.5) << sun_deg;
  }
}

TEST(Twilight, FallsWithTheSunToTheNightsOwnLight) {
  double before = lux_under(0.5);
  for (double sun_deg = 0.0; sun_deg >= -18.0; sun_deg -= 1.0) {
    const double now = lux_under(sun_deg);
    EXPECT_LT(now, before) << sun_deg;
    before = now;
  }
  for (const double sun_deg : {-30.0, -90.0}) {
    const dvec3 zenith = sky_under(sun_deg).radiance({0.0, 1.0, 0.0});
    EXPECT_NEAR(kSunLux * luminance(zenith), 1.7e-4, 1e-5) << sun_deg;
  }
}

/// Expects no green cast: green may not exceed both red and blue.
void expect_no_green(const dvec3& light) {
  EXPECT_LT(light.y, 1.08 * std::max(light.x, light.z))
      << light.x / light.y << ", " << light.z / light.y;
}

void expect_no_green(const SkyTable& sky) {
  expect_no_green(sky.irradiance_from_above());
  for (const double up : {0.05, 0.3, 1.0, 10.0}) {
    for (const double side : {-1.0, 0.0, 1.0}) {
      SCOPED_TRACE(std::to_string(up) + " up, " + std::to_string(side));
      expect_no_green(sky.radiance(glm::normalize(dvec3(0.5 * (1.0 - side * side), up, side))));
    }
  }
}

TEST(Twilight, IsNeverGreen) {
  for (double sun_deg = 0.0; sun_deg >= -18.0; sun_deg -= 1.0) {
    SCOPED_TRACE(sun_deg);
    expect_no_green(sky_under(sun_deg));
  }
  expect_no_green(sky_under(-30.0));
  for (const auto biome : {scene::BiomeKind::tropical, scene::BiomeKind::sand}) {
    for (const double sun_deg : {-3.0, -9.0, -16.0}) {
      SCOPED_TRACE(sun_deg);
      expect_no_green(solve(sun_deg, biome));
    }
  }
}

TEST(Twilight, IsBlueAndThenGrey) {
  for (const double sun_deg : {-2.0, -4.0, -6.0, -8.0, -10.0, -12.0}) {
    const dvec3 sky = sky_under(sun_deg).irradiance_from_above();
    EXPECT_GT(sky.z, 1.1 * sky.y) << sun_deg;
    EXPECT_GT(sky.y, 1.02 * sky.x) << sun_deg;
  }
  for (const double sun_deg : {-15.0, -17.0, -30.0}) {
    const dvec3 sky = sky_under(sun_deg).irradiance_from_above();
    EXPECT_NEAR(sky.x / sky.y, 1.0, 0.03) << sun_deg;
    EXPECT_NEAR(sky.z / sky.y, 1.0, 0.03) << sun_deg;
  }
}

}  // namespace
}  // namespace aerostat::air
