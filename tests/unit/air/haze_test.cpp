// Tests haze so thick that it hides the sky, up to fog. Light is lost only by absorption, and none
// is gained.

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

dvec3 sun_at(double elevation_deg) {
  const double e = elevation_deg * kPi64 / 180.0;
  return {0.0, std::sin(e), -std::cos(e)};
}

scene::Scene hazy(double visibility_m, double sun_deg = 60.0) {
  auto scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  scene.haze.visibility_m = visibility_m;
  scene::set_haze_droplets(scene.haze, visibility_m);
  scene.sun.direction = sun_at(sun_deg);
  scene.camera.position = {0.0, 5.0, 0.0};
  return scene;
}

/// Returns a scene with grey droplets that absorb nothing, over a land that reflects nothing.
scene::Scene white_haze(double visibility_m, double sun_deg = 60.0) {
  auto scene = hazy(visibility_m, sun_deg);
  scene.haze.albedo = vec3(1.0f);
  scene.haze.angstrom = 0.0;
  scene.air.ground_albedo = vec3(0.0f);
  return scene;
}

/// Returns the share of the light from above the air that reaches level ground.
dvec3 share_on_the_ground(const scene::Scene& scene) {
  const Light light(test::resolved(scene));
  return light.sky.irradiance_from_above() / scene.sun.direction.y +
         glm::exp(-light.depth_molecules - light.depth_haze - light.depth_ozone);
}

bool is_light(const dvec3& c) {
  return std::isfinite(c.x + c.y + c.z) && c.x >= 0.0 && c.y >= 0.0 && c.z >= 0.0;
}

TEST(ThickHaze, IsNotThatOfTheUsualScenes) {
  for (const auto biome :
       {scene::BiomeKind::snow, scene::BiomeKind::tropical, scene::BiomeKind::sand}) {
    EXPECT_EQ(thick_haze_share(atmosphere_of(scene::defaults(biome, scene::View::outside))), 0.0);
  }
  EXPECT_EQ(thick_haze_share(atmosphere_of(hazy(5000.0))), 1.0);
  auto layer = hazy(50.0);
  layer.haze.scale_height_m = 1.0;
  EXPECT_EQ(thick_haze_share(atmosphere_of(layer)), 0.0) << "too thin a layer";
}

TEST(ThickHaze, LetsThroughWhatTwoStreamsDo) {
  for (const double visibility_m : {50.0, 200.0, 1000.0, 5000.0}) {
    const auto scene = white_haze(visibility_m);
    const double depth = atmosphere_of(scene).haze_extinction.y * scene.haze.scale_height_m;
    const double expected = 1.0 / (1.0 + 0.75 * (1.0 - scene.haze.asymmetry) * depth);
    const dvec3 found = share_on_the_ground(scene);
    EXPECT_GT(found.y, 0.75 * expected) << visibility_m;
    EXPECT_LT(found.y, 1.4 * expected) << visibility_m;
  }
}

TEST(ThickHaze, GivesNoMoreLightThanItGets) {
  for (const double visibility_m : {10.0, 500.0, 20000.0}) {
    for (const double height_m : {20.0, 1200.0, 1e6}) {
      auto scene = white_haze(visibility_m, 25.0);
      scene.haze.scale_height_m = height_m;
      const dvec3 share = share_on_the_ground(scene);
      EXPECT_TRUE(is_light(share));
      EXPECT_LT(std::max({share.x, share.y, share.z}), 1.05)
          << visibility_m << " m, scale height " << height_m << " m";
    }
  }
}

TEST(ThickHaze, DimsTheMoreTheThickerItIs) {
  double before = 0.0;
  for (const double visibility_m : {10.0, 50.0, 200.0, 1000.0, 5000.0, 20000.0, 200000.0}) {
    const double now = share_on_the_ground(hazy(visibility_m, 17.0)).y;
    EXPECT_GT(now, before) << visibility_m;
    before = now;
  }
}

TEST(ThickHaze, LooksLikeFogOfTheSameExtinction) {
  for (const double visibility_m : {200.0, 1000.0}) {
    auto misty = white_haze(visibility_m), foggy = white_haze(1e7);
    misty.air.ground_albedo = foggy.air.ground_albedo = vec3(0.5f);
    misty.haze.asymmetry = kFogAsymmetry;
    foggy.fog = {true, visibility_m, misty.haze.scale_height_m, 20.0, 0.0, 900.0};
    const Light haze(test::resolved(misty)), fog(test::resolved(foggy));
    for (const double slope : {0.0, 0.4, 0.9}) {
      const dvec3 direction = glm::normalize(dvec3(1.0, slope, 0.2));
      const dvec3 a = haze.sky.radiance(direction), b = fog.sky.radiance(direction);
      EXPECT_GT(a.y, b.y / 1.8) << visibility_m << ", " << slope;
      EXPECT_LT(a.y, b.y * 1.8) << visibility_m << ", " << slope;
      EXPECT_NEAR(a.x / a.y, b.x / b.y, 0.12) << visibility_m << ", " << slope;
      EXPECT_NEAR(a.z / a.y, b.z / b.y, 0.12) << visibility_m << ", " << slope;
    }
  }
}

TEST(ThickHaze, IsGreyAndBright) {
  for (const double visibility_m : {50.0, 500.0, 2000.0}) {
    const auto scene = hazy(visibility_m, 17.0);
    const Light light(test::resolved(scene));
    const double overcast = light.sky.irradiance_from_above().y / kPi64;
    for (const double slope : {0.02, 0.3, 1.0, 10.0}) {
      for (const double side : {-1.0, 1.0}) {
        const dvec3 sky = light.sky.radiance(glm::normalize(dvec3(0.3, slope, side)));
        // In thinner haze, the side of a low sun is visibly warm.
        if (visibility_m > 1000.0 && side < 0.0) continue;
        EXPECT_NEAR(sky.x / sky.y, 1.0, 0.15) << visibility_m << ", " << slope;
        EXPECT_NEAR(sky.z / sky.y, 1.0, 0.25) << visibility_m << ", " << slope;
        if (visibility_m > 1000.0) continue;
        EXPECT_GT(sky.y, 0.4 * overcast) << visibility_m << ", " << slope;
        EXPECT_LT(sky.y, 2.0 * overcast) << visibility_m << ", " << slope;
      }
    }
  }
}

/// Returns the light around the eye in the haze as the kernels compute it.
dvec3 around_on_device(const Light& light, double height) {
  const double thinner = -std::expm1(-height / light.atmosphere.haze_height);
  const double x = std::min(light.thick_haze ? thinner : height, light.around_top);
  const auto& c = light.around;
  return glm::max(c[0] + x * (c[1] + x * c[2]), light.around_least);
}

TEST(ThickHaze, IsFollowedOverTheHeightsOfALandscape) {
  for (const double visibility_m : {50.0, 1000.0}) {
    for (const double scale_height_m : {50.0, 1200.0, 1e6}) {
      auto scene = hazy(visibility_m, 17.0);
      scene.haze.scale_height_m = scale_height_m;
      const Light light(test::resolved(scene));
      const Scattering air(light.atmosphere, scene.sun.direction);
      for (const double share : {0.0, 0.2, 0.7, 1.5}) {
        const double height = std::min(share * scale_height_m, 4000.0);
        const dvec3 expected = air.around(height, air.sun().y).even;
        const dvec3 found = around_on_device(light, height);
        ASSERT_TRUE(is_light(found));
        EXPECT_NEAR(found.y, expected.y, 0.25 * expected.y + 1e-5)
            << visibility_m << " m, scale height " << scale_height_m << " m, at " << height;
      }
    }
  }
}

TEST(AnyAir, GivesLightAndNothingBelowIt) {
  std::mt19937 random(41);
  const auto between = [&random](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const auto magnitude = [&between](double a, double b) {
    return std::pow(10.0, between(std::log10(a), std::log10(b)));
  };
  for (int i = 0; i < 12; ++i) {
    auto scene = scene::defaults(scene::BiomeKind::sand, scene::View::outside);
    scene.haze = {magnitude(10.0, 1e7), magnitude(1.0, 1e6), between(-1.0, 4.0), between(0.0, 0.95),
                  vec3(dvec3(between(0.0, 1.0), 1.0, between(0.0, 1.0)))};
    scene.air = {i % 6 == 0 ? 5e-324 : between(0.0, 10.0), between(0.0, 3000.0),
                 vec3(dvec3(between(0.0, 1.0)))};
    if (i % 3 == 0) scene.haze.albedo.x = scene.haze.albedo.z = 0.0f;
    scene.sun.direction = sun_at(i % 3 == 0 ? between(-12.0, 4.0) : between(-90.0, 90.0));
    scene.camera.position->y = magnitude(1.0, 2e5);
    scene.fog.enabled = i % 4 == 0;
    SCOPED_TRACE(scene::write_text(scene));
    const Light light(test::resolved(scene));
    ASSERT_TRUE(is_light(light.depth_haze) && is_light(light.scattered_depth_haze));
    for (const double height : {0.0, 1.0, 300.0, 9000.0, 1e5}) {
      ASSERT_TRUE(is_light(around_on_device(light, height))) << height;
    }
    for (const auto& cell : light.sky.cells()) {
      ASSERT_TRUE(is_light(cell.add) && is_light(cell.haze));
      // The bound is that of an even sky that sends as much light as the sun, over a white land,
      // with the glow of the sun.
      ASSERT_LT(std::max({cell.add.x, cell.add.y, cell.add.z}), 1.0);
    }
    for (const dvec3& part : light.ambient) ASSERT_TRUE(std::isfinite(part.x + part.y + part.z));
  }
}

}  // namespace
}  // namespace aerostat::air
