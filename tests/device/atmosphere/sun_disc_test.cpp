// Tests the disc of the sun in the sky.
#include <cmath>
#include <utility>

#include "air/atmosphere.hpp"
#include "pack/pack_scene.hpp"
#include "scene/io.hpp"
#include "shading_scene.hpp"
#include "support/resolved.hpp"

namespace aerostat::test {
namespace {

scene::Scene sunny(double elevation_deg) {
  auto scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  const auto elevation = radians_from_degrees(static_cast<float>(elevation_deg));
  scene.sun.direction = dvec3(direction_from_angles(radians_from_degrees(230.0f), elevation));
  scene.camera.position = {0.0, 400.0, 0.0};
  scene.sky.cloud_cover = 0.0;
  return scene;
}

class SunDisc : public LaneTest {
 protected:
  const Probe probe{"shading.cl", GetParam()};

  /// Returns for each direction the light of the air, and the radiance with the sun.
  std::pair<std::vector<vec3>, std::vector<vec3>> look(const pack::PackedScene& scene,
                                                       const std::vector<vec3>& directions) const {
    const std::size_t count = whole_packets(directions.size());
    const auto light = output<float>(3 * count), radiance = output<float>(3 * count);
    const UploadedScene on_device(scene);
    const std::vector<vec3> origins(directions.size(), vec3(10.0f, 400.0f, -20.0f));
    probe.run("probe_sky", count, on_device.numbers, on_device.sky_table, on_device.cloud_chart,
              input(planes(origins)), input(planes(directions)), light, radiance);
    std::pair<std::vector<vec3>, std::vector<vec3>> result;
    const auto sky = light.read(), all = radiance.read();
    for (std::size_t i = 0; i < directions.size(); ++i) {
      result.first.push_back(from_planes(sky, i));
      result.second.push_back(from_planes(all, i));
    }
    return result;
  }
};

TEST_P(SunDisc, IsSeenAndNothingOfItElsewhere) {
  const scene::Scene scene = sunny(15.0);
  const vec3 sun(scene.sun.direction);
  const vec3 side = glm::normalize(glm::cross(sun, vec3(0, 1, 0)));
  std::vector<vec3> directions;
  for (const float degrees : {0.0f, 0.2f, 0.35f, 1.0f}) {
    const float a = radians_from_degrees(degrees);
    directions.push_back(std::cos(a) * sun + std::sin(a) * side);
  }
  const auto [sky, radiance] = look(pack::pack_scene(resolved(scene)), directions);
  const auto disc = [&, &s = sky, &r = radiance](std::size_t i) {
    return glm::length(r[i] - s[i]);
  };
  EXPECT_GT(disc(0), 10.0f);
  EXPECT_GT(disc(1), 10.0f);
  EXPECT_EQ(disc(2), 0.0f);
  EXPECT_EQ(disc(3), 0.0f);
}

// All of the disc together gives the sun's irradiance. Its rim is darker and redder than its
// middle.
TEST_P(SunDisc, GivesTheWholeIrradiance) {
  constexpr int kRows = 64;
  scene::Scene scene = sunny(60.0);
  scene.haze.visibility_m = 1e6;
  const vec3 sun(scene.sun.direction);
  const vec3 side = glm::normalize(glm::cross(sun, vec3(0, 1, 0))), up = glm::cross(side, sun);
  const float reach = 1.1f * static_cast<float>(air::kSunRadius), cell = 2.0f * reach / kRows;
  std::vector<vec3> directions;
  for (int i = 0; i < kRows * kRows; ++i) {
    const float x = cell * (static_cast<float>(i % kRows) + 0.5f) - reach;
    const float y = cell * (static_cast<float>(i / kRows) + 0.5f) - reach;
    directions.push_back(sun + x * side + y * up);
  }
  const pack::PackedScene packed = pack::pack_scene(resolved(scene));
  const auto [sky, radiance] = look(packed, directions);
  vec3 whole(0.0f);
  for (std::size_t i = 0; i < sky.size(); ++i) whole += (radiance[i] - sky[i]) * (cell * cell);
  const auto light = output<float>(3 * kRows), around = output<float>(3 * kRows);
  probe.run("probe_sun", kRows, uploaded(packed.numbers), input(std::vector<float>(kRows, 400.0f)),
            input(planes(std::vector<vec3>(kRows, vec3(0, 1, 0)))), light, around);
  const vec3 expected = from_planes(light.read(), 0);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(whole[i], expected[i], 0.02f * expected[i]) << i;
  const auto at = [&, &s = sky, &r = radiance](int column) {
    const auto i = static_cast<std::size_t>(kRows * (kRows / 2) + column);
    return r[i] - s[i];
  };
  const vec3 middle = at(kRows / 2), rim = at(4);
  EXPECT_GT(rim.y, 0.2f * middle.y);
  EXPECT_LT(rim.y, 0.7f * middle.y);
  EXPECT_GT(rim.x / rim.z, 1.05f * middle.x / middle.z);
}

AEROSTAT_AT_EVERY_WIDTH(SunDisc);

}  // namespace
}  // namespace aerostat::test
