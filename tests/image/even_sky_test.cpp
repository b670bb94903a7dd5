// Tests a sky of one radiance with a sun, and plain surfaces under it, against closed forms.
#include <cmath>
#include <numbers>

#include "flat_land.hpp"

namespace aerostat::test {
namespace {

constexpr dvec3 kSky{0.25, 0.5, 2.0};
constexpr double kIrradiance = 3.0;
constexpr scene::Integrator kIntegrators[] = {scene::Integrator::local, scene::Integrator::path};

scene::Scene plain_land() {
  scene::Scene scene = flat_land();
  scene.surfaces = scene::Surfaces::plain;
  scene.sky.radiance = vec3(kSky);
  // None of these may be seen.
  scene.sky.cloud_cover = 1.0;
  scene.sky.cumulus.cover = 0.5;
  scene.haze.visibility_m = 500.0;
  scene.fog.enabled = true;
  scene.biome.ground.cover_a = scene.biome.ground.cover_b = vec3(1.0f, 0.0f, 0.0f);
  scene.biome.ground.relief = 1.0;
  scene.biome.ground.sparkle = 1.0;
  scene.material(scene::MaterialId::terrain).albedo = vec3(kAlbedo);
  scene.material(scene::MaterialId::terrain).specular = 1.0;
  scene.material(scene::MaterialId::terrain).emission = vec3(1.0f);
  scene.sun.irradiance = 0.0;
  return scene;
}

TEST(EvenSky, IsTheSameInEveryDirection) {
  for (const auto light : kIntegrators) {
    scene::Scene scene = plain_land();
    scene.light = light;
    scene.terrain.base_m = -5000.0;
    scene.terrain.size_m = 10.0;
    scene.camera.lens = scene::Lens::panorama;
    scene.camera.target = {0.0, kEyeHeight, -1.0};
    scene.camera.up = {0.0, 1.0, 0.0};
    const image::Film film = shared_session().render(resolved(scene));
    int sky = 0;
    for (std::size_t i = 0; i < film.radiance.size(); ++i) {
      if (film.object_id[i] != 0) continue;
      ++sky;
      ASSERT_EQ(film.radiance[i], vec3(kSky)) << i;
    }
    EXPECT_GT(sky, film.width * film.height * 9 / 10) << "also below the horizon";
  }
}

TEST(EvenSky, AndSunLightAPlane) {
  scene::Scene scene = plain_land();
  scene.sun.irradiance = kIrradiance;
  scene.sun.color = {1.0f, 0.5f, 0.25f};
  scene.sun.direction = glm::normalize(dvec3(0.3, 1.0, -0.2));
  const dvec3 sun =
      dvec3(scene.sun.color) * (kIrradiance * scene.sun.direction.y / std::numbers::pi);
  for_pixels(scene, [&](const dvec3&, const dvec3& radiance) {
    expect_radiance(kAlbedo * (kSky + sun), radiance);
  });
}

/// The mean over points of the disc differs from that of a sun in its middle by less than the
/// noise.
TEST(EvenSky, AndAWideSunLightAPlane) {
  scene::Scene scene = plain_land();
  scene.light = scene::Integrator::path;
  scene.image.spp = 64;
  scene.sun.irradiance = kIrradiance;
  scene.sun.soft_shadows = true;
  scene.sun.direction = glm::normalize(dvec3(0.6, 0.5, -0.2));
  for (const double diameter_deg : {0.1, 0.53, 4.0}) {
    scene.sun.diameter_deg = diameter_deg;
    const image::Film film = shared_session().render(resolved(scene));
    dvec3 mean(0.0);
    for (const vec3& radiance : film.radiance) mean += dvec3(radiance);
    mean /= static_cast<double>(film.radiance.size());
    const double sun = kIrradiance * scene.sun.direction.y / std::numbers::pi;
    expect_radiance(kAlbedo * (kSky + sun), mean, 5e-4);
  }
}

TEST(EvenSky, LightsAPlaneByPaths) {
  scene::Scene scene = plain_land();
  scene.light = scene::Integrator::path;
  scene.image.spp = 64;
  dvec3 mean(0.0);
  for_pixels(scene, [&](const dvec3&, const dvec3& radiance) { mean += radiance; });
  mean /= static_cast<double>(scene.image.width) * scene.image.height;
  expect_radiance(kAlbedo * kSky, mean, 2e-3);
}

/// The eye sees a disc of the radiance E / (pi sin^2), so that the mean over a picture that holds
/// it is that times its share of the solid angle.
TEST(EvenSky, ShowsTheSunAsBrightAsItIs) {
  scene::Scene scene = plain_land();
  scene.sun.irradiance = kIrradiance;
  scene.sun.direction = {0.0, 1.0, 0.0};
  scene.sun.diameter_deg = 1.0;
  scene.camera.target = {0.0, 2.0 * kEyeHeight, 0.0};
  scene.camera.fov_y_deg = 2.0;
  scene.image.spp = 64;
  scene.image.filter = scene::Filter::box;
  const double sine = std::sin(glm::radians(0.5));
  const double disc = kIrradiance / (std::numbers::pi * sine * sine);
  for (const auto light : kIntegrators) {
    scene.light = light;
    const image::Film film = shared_session().render(resolved(scene));
    double mean = 0.0;
    for (const vec3& radiance : film.radiance) mean += static_cast<double>(radiance.y);
    mean /= static_cast<double>(film.radiance.size());
    const double half = std::tan(glm::radians(1.0)), radius = std::tan(glm::radians(0.5));
    const double aspect = static_cast<double>(film.width) / film.height;
    const double share = std::numbers::pi * radius * radius / (4.0 * half * half * aspect);
    EXPECT_NEAR(mean, kSky.y + share * disc, 0.01 * share * disc);
    const std::size_t middle = film.radiance.size() / 2 + static_cast<std::size_t>(film.width) / 2;
    EXPECT_NEAR(film.radiance[middle].y, kSky.y + disc, 1e-4 * disc);
  }
}

}  // namespace
}  // namespace aerostat::test
