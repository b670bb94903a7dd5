// Tests gloss, lamps and air at pixels whose values are known in closed form.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "flat_land.hpp"

namespace aerostat::test {
namespace {

constexpr double kPi64 = std::numbers::pi;

scene::Material& ground_material(scene::Scene& scene) {
  return scene.material(scene::MaterialId::terrain);
}

/// Tests Phong's reflection: L = E / pi (albedo cos + k_s (r . v)^m), which is brightest where the
/// mirrored sun is seen.
TEST(Specular, HasItsPeakAndShapeWhereTheyMustBe) {
  auto scene = flat_land();
  scene.sun.irradiance = kPi64;
  scene.sun.direction = glm::normalize(dvec3(0.25, 1.0, -0.15));
  ground_material(scene).specular = 0.7;
  ground_material(scene).shininess = 80.0;
  const dvec3 sun = scene.sun.direction;
  const dvec3 mirrored(-sun.x, sun.y, -sun.z);
  dvec3 brightest_point(0.0);
  double brightest = 0.0;
  for_pixels(scene, [&](const dvec3& point, const dvec3& radiance) {
    const dvec3 to_eye = glm::normalize(*scene.camera.position - point);
    const double lobe = std::pow(std::max(glm::dot(mirrored, to_eye), 0.0), 80.0);
    expect_radiance(kAlbedo * sun.y + 0.7 * lobe, radiance, 1e-4);
    if (radiance.x > brightest) {
      brightest = radiance.x;
      brightest_point = point;
    }
  });
  // The eye sees the mirrored sun at the point from which the mirrored ray of the sun reaches the
  // eye.
  const dvec3 peak = dvec3(sun.x, 0.0, sun.z) * (kEyeHeight / sun.y);
  const double pixel = glm::distance(point_under(scene, 0, 0), point_under(scene, 1, 0));
  EXPECT_LT(glm::distance(brightest_point, peak), pixel);
  EXPECT_NEAR(brightest, kAlbedo.x * sun.y + 0.7, 0.01);
}

TEST(Specular, IsNotSeenInTheShadow) {
  auto scene = flat_land();
  scene.sun.irradiance = kPi64;
  scene.sun.direction = {0.0, 1.0, 0.0};
  scene.balloon.enabled = true;
  scene.balloon.position = {0.0, kEyeHeight + 5.0, 0.0};
  // The picture shows only the shadow.
  scene.camera.fov_y_deg = 20.0;
  ground_material(scene).specular = 1.0;
  for_pixels(scene, [](const dvec3&, const dvec3& radiance) { EXPECT_EQ(radiance, dvec3(0.0)); });
}

/// Tests a lamp: L = albedo / pi * I * cos / d^2.
TEST(Lamp, FallsOffWithTheSquareOfTheDistance) {
  auto scene = flat_land();
  const dvec3 lamp(4.0, 6.0, -3.0);
  const dvec3 color(1.0, 0.5, 0.25);
  for (const bool shadows : {false, true}) {
    scene.lights = {{lamp, vec3(color), 250.0, shadows}};
    for_pixels(scene, [&](const dvec3& point, const dvec3& radiance) {
      const dvec3 towards = lamp - point;
      const double squared = glm::dot(towards, towards);
      const double cosine = lamp.y / std::sqrt(squared);
      expect_radiance(kAlbedo * color * (250.0 * cosine / squared / kPi64), radiance);
    });
  }
}

TEST(Lamp, AddsToTheOthers) {
  auto scene = flat_land();
  const std::vector<scene::PointLight> lamps = {{{4.0, 6.0, -3.0}, vec3(1.0f), 250.0, true},
                                                {{-5.0, 3.0, 2.0}, vec3(1.0f), 90.0, true},
                                                {{0.0, 9.0, 8.0}, vec3(1.0f), 400.0, true}};
  const auto render_with = [&](std::vector<scene::PointLight> lights) {
    scene.lights = std::move(lights);
    return shared_session().render(resolved(scene));
  };
  const image::Film all = render_with(lamps);
  std::vector<image::Film> single;
  for (const auto& lamp : lamps) single.push_back(render_with({lamp}));
  for (std::size_t i = 0; i < all.radiance.size(); ++i) {
    const vec3 sum = single[0].radiance[i] + single[1].radiance[i] + single[2].radiance[i];
    expect_radiance(dvec3(sum), dvec3(all.radiance[i]), 1e-5);
  }
}

/// Returns the mean radiance of the envelopes in the left and in the right half of a film.
dvec2 light_of_envelopes(const image::Film& film) {
  dvec2 sum(0.0), count(0.0);
  for (int i = 0; i < film.width * film.height; ++i) {
    const auto pixel = static_cast<std::size_t>(i);
    if (film.object_id[pixel] != static_cast<std::uint32_t>(scene::ObjectId::envelope)) continue;
    const int half = i % film.width < film.width / 2 ? 0 : 1;
    sum[half] += static_cast<double>(film.radiance[pixel].y);
    count[half] += 1.0;
  }
  EXPECT_GT(std::min(count.x, count.y), 100.0) << "both envelopes must be in the picture";
  return sum / count;
}

TEST(Burners, LightTheEnvelopeOfTheirOwnBalloon) {
  auto scene = flat_land();
  scene.camera.position = {0.0, 20.0, 90.0};
  scene.camera.target = {0.0, 20.0, 0.0};
  scene.camera.up = {0.0, 1.0, 0.0};
  scene.balloon.enabled = true;
  scene.balloon.position = {-20.0, 12.0, 0.0};
  scene.balloons.assign(1, scene.balloon);
  scene.balloons[0].position.x = 20.0;
  scene.balloons[0].colors = scene.balloon.colors;
  for (const bool left : {false, true}) {
    scene.balloon.burner = left ? 1.0 : 0.0;
    scene.balloons[0].burner = left ? 0.0 : 1.0;
    const dvec2 light = light_of_envelopes(shared_session().render(resolved(scene)));
    EXPECT_GT(left ? light.x : light.y, 1e-5);
    EXPECT_EQ(left ? light.y : light.x, 0.0);
  }
}

void paint(scene::Scene& scene, const vec3& color) {
  scene::Ground& ground = scene.biome.ground;
  ground.cover_a = ground.cover_b = ground.rock_a = ground.rock_b = color;
  ground.snow = ground.beach = color;
}

/// Expects the transmittance of the air in every pixel. The radiance of a white ground minus that
/// of a black one is the light of the ground times the transmittance, because the air's own light
/// is subtracted. The ground is lit by a lamp, which no air dims. Green is the colour for which the
/// visibility is defined.
void expect_transmittance(double visibility_m, double scale_height_m) {
  auto scene = flat_land();
  scene.haze.visibility_m = visibility_m;
  scene.haze.scale_height_m = scale_height_m;
  const dvec3 lamp(0.0, 8.0, 0.0);
  scene.lights = {{lamp, vec3(1.0f), 100.0, false}};
  paint(scene, vec3(1.0f));
  const image::Film white = shared_session().render(resolved(scene));
  paint(scene, vec3(0.0f));
  const image::Film black = shared_session().render(resolved(scene));
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const auto i = static_cast<std::size_t>(y * 64 + x);
      const dvec3 point = point_under(scene, x, y);
      const double distance = glm::distance(point, *scene.camera.position);
      const double to_lamp = glm::distance(point, lamp);
      const double lit = 100.0 * lamp.y / (to_lamp * to_lamp * to_lamp) / kPi64;
      // This is Koschmieder's extinction, integrated along the ray over exp(-height / scale
      // height).
      const double share = kEyeHeight / scale_height_m;
      const double tau = 3.912 / visibility_m * distance * (1.0 - std::exp(-share)) / share;
      const double found = static_cast<double>(white.radiance[i].y) - black.radiance[i].y;
      ASSERT_NEAR(found, lit * std::exp(-tau), 2e-5 * lit) << x << ", " << y;
    }
  }
}

TEST(Haze, DimsByBeersLaw) {
  expect_transmittance(60.0, 1e6);
}

TEST(Haze, ThinsOutWithHeight) {
  expect_transmittance(60.0, 12.0);
}

TEST(Haze, HidesTheGroundWhereItIsDense) {
  auto scene = flat_land();
  scene.sun.irradiance = 3.0;
  scene.sun.direction = glm::normalize(dvec3(1.0, 1.0, 0.0));
  scene.haze.visibility_m = 8.0;
  scene.haze.scale_height_m = 30.0;
  scene.haze.albedo = vec3(0.9f);
  paint(scene, vec3(1.0f));
  const image::Film white = shared_session().render(resolved(scene));
  paint(scene, vec3(0.0f));
  const image::Film black = shared_session().render(resolved(scene));
  for (std::size_t i = 0; i < white.radiance.size(); ++i) {
    ASSERT_GT(black.radiance[i].y, 0.0f);
    ASSERT_NEAR(white.radiance[i].y, black.radiance[i].y, 1e-2f * black.radiance[i].y);
  }
}

}  // namespace
}  // namespace aerostat::test
