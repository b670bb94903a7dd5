// Tests that sky, sunlight and distance follow from the same air.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "air/light.hpp"
#include "scene/io.hpp"
#include "support/resolved.hpp"

namespace aerostat::air {
namespace {

constexpr double kPi64 = std::numbers::pi;

dvec3 towards(double azimuth_deg, double elevation_deg) {
  const double a = azimuth_deg * kPi64 / 180.0, e = elevation_deg * kPi64 / 180.0;
  return {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
}

scene::Scene morning(double sun_elevation_deg = 15.0) {
  auto scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  scene.sun.direction = towards(230.0, sun_elevation_deg);
  scene.camera.position = {0.0, 400.0, 0.0};
  return scene;
}

bool is_light(const dvec3& c) {
  return std::isfinite(c.x + c.y + c.z) && c.x >= 0.0 && c.y >= 0.0 && c.z >= 0.0;
}

TEST(Way, OfAUniformLayerIsKnownInClosedForm) {
  Atmosphere air;
  // This haze absorbs and scatters nothing.
  air.haze_extinction = {1e-5, 2e-5, 4e-5};
  air.haze_height = 1e12;
  const Scattering light(air, towards(0.0, 30.0));
  const PathLight path = light.follow({0.0, {0.0, 1.0, 0.0}, 30000.0}, 20);
  EXPECT_LT(glm::distance(path.transmittance, glm::exp(-30000.0 * air.haze_extinction)), 1e-6);
  EXPECT_EQ(path.add, dvec3(0.0));
}

TEST(Way, GoesOnFromItsMiddle) {
  const Scattering light(atmosphere_of(morning()), morning().sun.direction);
  const Way whole{400.0, towards(300.0, 2.0), 60000.0};
  Way near = whole, far = whole;
  near.length = 15000.0;
  far.length = 45000.0;
  far.height = height_after(400.0, whole.direction.y, near.length);
  // The upright direction turns by this angle along the first part of the path.
  const double turn = near.length / (kGroundRadius + 400.0);
  far.direction.y += turn;
  far.direction = glm::normalize(far.direction);
  const PathLight a = light.follow(near, 200), b = light.follow(far, 200);
  const PathLight both = light.follow(whole, 200);
  const dvec3 add = a.add + a.transmittance * b.add;
  EXPECT_LT(glm::length(add - both.add), 0.01 * glm::length(both.add));
  const dvec3 through = a.transmittance * b.transmittance;
  EXPECT_LT(glm::length(through - both.transmittance), 0.01 * glm::length(both.transmittance));
}

TEST(Sky, IsTheWayOutOfTheAir) {
  const scene::Scene scene = morning();
  const Light light(test::resolved(scene));
  const Scattering air(light.atmosphere, scene.sun.direction);
  for (const double elevation_deg : {1.0, 5.0, 20.0, 45.0, 80.0}) {
    for (const double azimuth_deg : {20.0, 140.0, 225.0}) {
      const dvec3 direction = towards(azimuth_deg, elevation_deg);
      const PathLight path =
          air.follow({400.0, direction, way_to_the_end(400.0, direction.y)}, 200);
      const double phase =
          haze_phase(glm::dot(direction, scene.sun.direction), light.atmosphere.haze_asymmetry);
      const dvec3 expected = path.add + phase * path.haze;
      EXPECT_LT(glm::length(light.sky.radiance(direction) - expected), 0.02 * glm::length(expected))
          << azimuth_deg << ", " << elevation_deg;
    }
  }
}

TEST(Sky, IsBluerThanTheSunAndBrighterAtTheHorizon) {
  const Light light(test::resolved(morning(40.0)));
  const dvec3 above = light.sky.irradiance_from_above();
  ASSERT_TRUE(is_light(above));
  const dvec3 sun = Scattering(light.atmosphere, towards(230.0, 40.0)).sunlight(0.0, 0.64);
  EXPECT_GT(above.z / above.x, 2.0 * sun.z / sun.x);
  // A clear sky gives a tenth to a fifth of the light on level ground.
  const double share = above.y / (above.y + 0.64 * sun.y);
  EXPECT_GT(share, 0.08);
  EXPECT_LT(share, 0.25);
  const dvec3 zenith = light.sky.radiance({0.0, 1.0, 0.0});
  const dvec3 low = light.sky.radiance(towards(50.0, 3.0));
  EXPECT_GT(low.y, 2.0 * zenith.y);
  EXPECT_LT(low.z / low.x, zenith.z / zenith.x);
}

TEST(Sky, ReddensAtTheHorizonUnderALowSun) {
  const auto redness = [](double sun_deg) {
    const dvec3 glow = Light(test::resolved(morning(sun_deg))).sky.radiance(towards(225.0, 1.0));
    return glow.x / glow.z;
  };
  EXPECT_GT(redness(2.0), 2.0 * redness(20.0));
}

TEST(Sky, HoldsNumbersForEverySunAndDirection) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (double sun_deg = -10.0; sun_deg <= 90.0; sun_deg += 10.0) {
    SCOPED_TRACE("sun at " + std::to_string(sun_deg));
    const Light light(test::resolved(morning(sun_deg)));
    for (const dvec3& part : light.ambient) ASSERT_TRUE(std::isfinite(part.x + part.y + part.z));
    ASSERT_TRUE(is_light(light.depth_molecules) && is_light(light.depth_haze));
    for (int i = 0; i < 500; ++i) {
      const dvec3 direction =
          glm::normalize(dvec3(uniform(random), uniform(random), uniform(random)));
      ASSERT_TRUE(is_light(light.sky.radiance(direction))) << direction.y;
    }
    for (const dvec3& axis : {dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(1, 0, 0)}) {
      ASSERT_TRUE(is_light(light.sky.radiance(axis)));
    }
  }
}

TEST(Sky, DarkensAsTheSunGoesDown) {
  double before = 1e9;
  for (const double sun_deg : {60.0, 20.0, 5.0, 0.0, -3.0, -6.0, -10.0}) {
    const double now = Light(test::resolved(morning(sun_deg))).sky.irradiance_from_above().y;
    EXPECT_LT(now, before) << sun_deg;
    before = now;
  }
  EXPECT_LT(before, 1e-4);
}

/// Returns the irradiance divided by pi, computed by brute force.
dvec3 irradiance_over_pi(const SkyTable& sky, const dvec3& normal) {
  const int rings = 200, sectors = 200;
  dvec3 sum(0.0);
  for (int i = 0; i < rings; ++i) {
    const double y = -1.0 + (2.0 * i + 1.0) / rings, level = std::sqrt(1.0 - y * y);
    for (int j = 0; j < sectors; ++j) {
      const double a = 2.0 * kPi64 * (j + 0.5) / sectors;
      const dvec3 d{level * std::cos(a), y, level * std::sin(a)};
      sum += sky.radiance(d) * std::max(glm::dot(d, normal), 0.0);
    }
  }
  return sum * (4.0 / (rings * sectors));
}

TEST(AmbientLight, IsTheIrradianceOfEveryPlane) {
  scene::Scene clear = morning();
  clear.sky.cumulus.cover = 0.0;
  const Light light(test::resolved(clear));
  const auto& c = light.ambient;
  for (const dvec3& n : {dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(1, 0, 0), dvec3(0, 0, -1),
                         glm::normalize(dvec3(1, 2, -1)), glm::normalize(dvec3(-1, 1, 1))}) {
    const dvec3 found = c[0] + c[1] * n.y + c[2] * n.z + c[3] * n.x + c[4] * (n.x * n.y) +
                        c[5] * (n.y * n.z) + c[6] * (3.0 * n.z * n.z - 1.0) + c[7] * (n.x * n.z) +
                        c[8] * (n.x * n.x - n.y * n.y);
    const dvec3 expected = irradiance_over_pi(light.sky, n);
    // The harmonics beyond the ninth carry a few per cent of a lit sky.
    EXPECT_LT(glm::length(found - expected), 0.06 * glm::length(expected)) << n.x << ", " << n.y;
  }
}

TEST(LandscapeLight, FollowsTheAirOverTheHeightsOfALandscape) {
  for (const double sun_deg : {60.0, 20.0, 8.0, 3.0, 0.5, -0.5}) {
    SCOPED_TRACE("sun at " + std::to_string(sun_deg));
    const scene::Scene scene = morning(sun_deg);
    const Light light(test::resolved(scene));
    const Scattering air(light.atmosphere, scene.sun.direction);
    const double sun = scene.sun.direction.y;
    for (const double h : {0.0, 600.0, 1500.0, 3000.0}) {
      if (sun_share(h, sun) < 1.0) continue;
      const dvec3 depth = light.depth_molecules * std::exp(-h / light.atmosphere.molecules_height) +
                          light.depth_haze * std::exp(-h / light.atmosphere.haze_height) +
                          light.depth_ozone;
      const dvec3 expected = air.sunlight(h, sun);
      EXPECT_LT(glm::length(glm::exp(-depth) - expected), 0.05 * glm::length(expected)) << h;
      const dvec3 around = light.around[0] + h * (light.around[1] + h * light.around[2]);
      const dvec3 even = air.around(h, sun).even;
      EXPECT_LT(glm::length(around - even), 0.06 * glm::length(even)) << h;
    }
  }
}

}  // namespace
}  // namespace aerostat::air
