// Tests moon, stars and moonlight on the device against closed forms and against the host.
#include <cmath>
#include <numbers>

#include "air/light.hpp"
#include "pack/pack_scene.hpp"
#include "pack/star_catalogue.hpp"
#include "scene/io.hpp"
#include "scene/key_light.hpp"
#include "scene/moonlight.hpp"
#include "shading_scene.hpp"
#include "support/resolved.hpp"

namespace aerostat::test {
namespace {

constexpr double kPi64 = std::numbers::pi;

dvec3 direction_of(double azimuth_deg, double elevation_deg) {
  const double a = azimuth_deg * kPi64 / 180.0, e = elevation_deg * kPi64 / 180.0;
  return {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)};
}

/// Returns a land without air, so that what stands in the sky is seen as it is.
scene::Scene airless(double sun_deg) {
  auto scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  scene.air.density = 0.0;
  scene.air.ozone_du = 0.0;
  scene.haze.visibility_m = 1e7;
  scene.sky.cloud_cover = 0.0;
  scene.camera.position = {0.0, 400.0, 0.0};
  scene.sun.direction = direction_of(90.0, sun_deg);
  return scene;
}

class Night : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};

  std::vector<dvec3> look(const pack::PackedScene& scene,
                          const std::vector<vec3>& directions) const {
    const std::size_t count = whole_packets(directions.size());
    const std::vector<vec3> origins(directions.size(), vec3(0.0f, 400.0f, 0.0f));
    const auto light = output<float>(3 * count), radiance = output<float>(3 * count);
    const UploadedScene on_device(scene);
    probe.run("probe_sky", count, on_device.numbers, on_device.sky_table, on_device.cloud_chart,
              input(planes(origins)), input(planes(directions)), light, radiance);
    const std::vector<float> values = radiance.read();
    std::vector<dvec3> result;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      result.emplace_back(from_planes(values, i));
    }
    return result;
  }

  /// Returns the irradiance that arrives from a small square of the sky around `middle`.
  dvec3 irradiance(const pack::PackedScene& scene, const dvec3& middle, double half_rad,
                   int side) const {
    const dvec3 right = glm::normalize(glm::cross(middle, dvec3(0.0, 1.0, 0.0)));
    const dvec3 up = glm::cross(right, middle);
    std::vector<vec3> directions;
    for (int i = 0; i < side * side; ++i) {
      const double x = (2.0 * (i % side + 0.5) / side - 1.0) * half_rad;
      const double y = (2.0 * (i / side + 0.5) / side - 1.0) * half_rad;
      directions.emplace_back(glm::normalize(middle + x * right + y * up));
    }
    dvec3 sum(0.0);
    for (const dvec3& radiance : look(scene, directions)) sum += radiance;
    return sum * std::pow(2.0 * half_rad / side, 2.0);
  }
};

TEST_P(Night, TheMoonsDiscHasTheLightOfItsMagnitude) {
  // By day, so that the disc is not dimmed; the air is gone. The pattern of dark plains changes the
  // mean of a half disc by a tenth or so.
  for (const double moon_azimuth_deg : {-89.0, 0.0, 30.0}) {
    scene::Scene scene = airless(10.0);
    scene.stars.enabled = false;
    scene.camera.fov_y_deg = 4.0;  // so that the rim is hardly smoothed
    scene.moon = {true, moon_azimuth_deg, 20.0, scene::kMeanMoonDistanceKm};
    const dvec3 moon = scene::moon_direction(scene.moon);
    const auto phase = scene::moon_phase(moon, scene.moon.distance_km, scene.sun.direction);
    const dvec3 expected = 5.0 * scene::moon_share_of_sun(phase.phase_rad, scene.moon.distance_km);
    pack::PackedScene packed = pack::pack_scene(resolved(scene));
    dvec3 found = irradiance(packed, moon, 0.006, 128);
    packed.numbers.night.moon.radius = 0.0f;
    found -= irradiance(packed, moon, 0.006, 128);  // what haze is left
    EXPECT_NEAR(found.y / expected.y, 1.0, 0.2) << moon_azimuth_deg;
    EXPECT_NEAR(found.x / found.z, expected.x / expected.z, 0.01) << moon_azimuth_deg;
  }
}

TEST_P(Night, TheMoonIsLitOnTheSideOfTheSun) {
  scene::Scene scene = airless(10.0);
  scene.moon = {true, 0.0, 10.0, scene::kMeanMoonDistanceKm};  // the sun is in the east
  const pack::PackedScene packed = pack::pack_scene(resolved(scene));
  const std::vector<dvec3> seen =
      look(packed, {vec3(direction_of(0.17, 10.0)), vec3(direction_of(-0.17, 10.0))});
  EXPECT_GT(seen[0].y, 20.0 * seen[1].y);
}

TEST_P(Night, AStarHasTheLightOfItsMagnitude) {
  scene::Scene scene = airless(-40.0);
  scene.moon.enabled = false;
  scene.stars.milky_way = 0.0;
  const pack::PackedScene packed = pack::pack_scene(resolved(scene));
  const float* rows = packed.numbers.night.stars.equator;
  int seen = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    const pack::Star& star = pack::star_catalogue()[i];
    dvec3 direction(0.0);
    for (int row = 0; row < 3; ++row) {
      direction += star.direction[row] * dvec3(rows[3 * row], rows[3 * row + 1], rows[3 * row + 2]);
    }
    if (direction.y < 0.1) continue;
    // Magnitude -26.74 is the sun. Where the blurs of two stars overlap, both are in the square.
    const double expected = 5.0 * std::pow(10.0, -0.4 * (star.magnitude + 26.74));
    const double half = 4.0 * std::sqrt(0.5 / packed.numbers.night.stars.sharpness);
    const dvec3 hue = pack::star_hue(star.color_index);
    const dvec3 found = irradiance(packed, direction, half, 32);
    EXPECT_GT(found.y, 0.98 * expected * hue.y) << i;
    EXPECT_LT(found.y, 1.25 * expected * hue.y + 1e-13) << i;
    ++seen;
  }
  EXPECT_GT(seen, 10);
}

TEST_P(Night, StarsAreHiddenByTheMoonAndByDay) {
  scene::Scene scene = airless(20.0);
  EXPECT_EQ(pack::pack_scene(resolved(scene)).numbers.night.stars.first, 0u);
  scene.sun.direction = direction_of(90.0, -30.0);
  scene.stars.milky_way = 10.0;
  scene.moon = {true, -90.0, 40.0, 200000.0};
  const dvec3 disc = direction_of(-90.0, 40.0);
  pack::PackedScene packed = pack::pack_scene(resolved(scene));
  for (float& part : packed.numbers.night.moon.radiance) part = 0.0f;
  const dvec3 behind = look(packed, {vec3(disc)})[0];
  packed.numbers.night.moon.radius = 0.0f;
  const dvec3 without = look(packed, {vec3(disc)})[0];
  EXPECT_LT(behind.y, without.y) << "the Milky Way shines through the moon";
}

TEST_P(Night, MoonlitAirIsThatOfTheMoonAndOfTheAfterglow) {
  auto scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  scene.sky.cloud_cover = 0.0;
  scene.stars.enabled = false;
  scene.camera.position = {0.0, 400.0, 0.0};
  scene.sun.direction = direction_of(90.0, -9.0);
  scene.moon = {true, -60.0, 25.0, scene::kMeanMoonDistanceKm};
  const air::Light both(resolved(scene));
  ASSERT_TRUE(both.afterglow.has_value());
  scene::Scene twilight = scene;
  twilight.moon.enabled = false;
  const air::Light sun(resolved(twilight));
  scene::Scene moonlight = twilight;
  const scene::KeyLight key = scene::key_light(scene);
  moonlight.sun.direction = key.direction;
  const air::Light moon(resolved(moonlight));
  const std::vector<vec3> directions = {vec3(direction_of(80.0, 5.0)),
                                        vec3(direction_of(0.0, 60.0)),
                                        vec3(direction_of(-170.0, 20.0))};
  const std::vector<dvec3> seen = look(pack::pack_scene(resolved(scene)), directions);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const dvec3 direction(directions[i]);
    const dvec3 expected = moon.sky.radiance(direction) * key.irradiance +
                           sun.sky.radiance(direction) * scene.sun.irradiance;
    EXPECT_LT(glm::distance(seen[i], expected), 3e-3 * glm::length(expected)) << i;
  }
  for (std::size_t k = 0; k < 9; ++k) {
    const dvec3 expected = moon.ambient[k] * key.irradiance + sun.ambient[k] * scene.sun.irradiance;
    EXPECT_LT(glm::distance(both.ambient[k] * key.irradiance, expected), 1e-9) << k;
  }
}

AEROSTAT_AT_EVERY_WIDTH(Night);

}  // namespace
}  // namespace aerostat::test
