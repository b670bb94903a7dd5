#include "flat_land.hpp"

#include <cmath>

#include "air/light.hpp"

namespace aerostat::test {
namespace {

scene::Ground one_colour() {
  scene::Ground ground;
  const vec3 albedo(kAlbedo);
  ground.cover_a = ground.cover_b = ground.rock_a = ground.rock_b = albedo;
  ground.snow = ground.beach = albedo;
  ground.relief = ground.ripple_m = ground.forest_share = 0.0;
  return ground;
}

}  // namespace

scene::Scene flat_land() {
  scene::Scene scene = scene::defaults(scene::BiomeKind::sand, scene::View::outside);
  scene.biome.ground = one_colour();
  scene.biome.water.enabled = false;
  scene.terrain.kind = scene::TerrainKind::dunes;
  scene.terrain.height_m = 0.0;
  // Cells far wider than the dunes leave out even the rounding of their crests. The land is level
  // to a billionth of a metre.
  scene.terrain.dunes.height_m = 1e-9;
  scene.terrain.dunes.wavelength_m = 1.0;
  scene.terrain.base_m = 0.0;
  scene.terrain.cells = 8;
  scene.terrain.size_m = 100.0;
  scene.terrain.grading = 1.0;
  scene.balloon.enabled = false;
  scene.vegetation.enabled = false;
  scene.balloon.height_above = scene::HeightReference::sea;
  scene.camera = {};
  scene.camera.position = {0.0, kEyeHeight, 0.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.camera.up = {0.0, 0.0, -1.0};
  scene.sun.irradiance = 0.0;
  scene.sun.color = vec3(1.0f);
  scene.sky.cumulus.cover = 0.0;
  scene.air = {0.0, 0.0, vec3(0.0f)};
  scene.haze.visibility_m = 1e12;
  scene.haze.albedo = vec3(0.0f);
  scene.material(scene::MaterialId::terrain) = {};
  scene.image.filter = scene::Filter::box;
  scene.image.width = 64;
  scene.image.height = 48;
  scene::set_quality(scene, scene::Quality::draft);
  return scene;
}

scene::Scene flat_land_under_a_sky() {
  scene::Scene scene = flat_land();
  scene.air.density = 1.0;
  scene.air.ground_albedo = vec3(0.3f);
  scene.sun.irradiance = 3.0;
  scene.sun.direction = {0.0, 1.0, 0.0};
  return scene;
}

dvec3 sky_light(const scene::Scene& scene) {
  const auto& c = air::Light(resolved(scene)).ambient;
  return (c[0] + c[1] - c[6] - c[8]) * dvec3(scene.sun.color) * scene.sun.irradiance;
}

dvec3 sunlight(const scene::Scene& scene) {
  const air::Scattering air(air::atmosphere_of(scene), scene.sun.direction);
  return air.sunlight(0.0, scene.sun.direction.y) * dvec3(scene.sun.color) *
         (scene.sun.irradiance / std::numbers::pi);
}

dvec3 point_under(const scene::Scene& scene, int x, int y) {
  const double half_height = 0.5 * scene.image.height;
  const double metres =
      kEyeHeight * std::tan(glm::radians(0.5 * scene.camera.fov_y_deg)) / half_height;
  return {(x + 0.5 - 0.5 * scene.image.width) * metres, 0.0, (y + 0.5 - half_height) * metres};
}

void expect_radiance(const dvec3& expected, const dvec3& found, double relative) {
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(found[c], expected[c], relative * expected[c] + 1e-7) << "channel " << c;
  }
}

}  // namespace aerostat::test
