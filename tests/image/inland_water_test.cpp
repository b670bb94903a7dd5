// Tests that lakes of real land are seen as water.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "real_land.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::test {
namespace {

constexpr double kLevel = 500.0;
constexpr dvec3 kSky{0.25, 0.5, 2.0};

/// Writes a bowl whose floor, 600 m in radius, is level, and returns a view onto it, with an even
/// sky above and water that gives nothing back from below its surface.
scene::Scene lake_below(const TemporaryFolder& folder) {
  const auto path = folder.path() / "bowl.asc";
  write_land(path, 65, 30.0, [](double east, double north) {
    return std::round(kLevel + std::max(0.0, 0.25 * (std::hypot(east, north) - 600.0)));
  });
  scene::Scene scene = bare_land(path, 1900.0, 128);
  scene.camera = {};
  scene.camera.position = {0.0, kLevel + 120.0, 260.0};
  scene.camera.target = {0.0, kLevel, 0.0};
  scene.camera.fov_y_deg = 8.0;
  scene.image.width = scene.image.height = 32;
  scene.sky.radiance = vec3(kSky);
  scene.sun.irradiance = 0.0;
  scene.biome.water.wave_slope = 0.0;
  scene.biome.water.scatter = vec3(0.0f);
  scene.biome.water.absorption_per_m = vec3(100.0f);
  return scene;
}

TEST(InlandWater, MirrorsTheSky) {
  const TemporaryFolder folder;
  const scene::Scene scene = lake_below(folder);
  const image::Film film = shared_session().render(resolved(scene));
  // By Schlick's approximation, at the angle of the middle of the picture.
  const double cosine = 120.0 / std::hypot(120.0, 260.0);
  const double mirrored = 0.0204 + (1.0 - 0.0204) * std::pow(1.0 - cosine, 5.0);
  dvec3 mean(0.0);
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    ASSERT_EQ(film.object_id[i], static_cast<std::uint32_t>(scene::ObjectId::water)) << i;
    mean += dvec3(film.radiance[i]) / static_cast<double>(film.radiance.size());
  }
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], mirrored * kSky[c], 0.06 * mirrored * kSky[c]);
}

TEST(InlandWater, IsLeftOutIfTheSceneSaysSo) {
  const TemporaryFolder folder;
  scene::Scene scene = lake_below(folder);
  scene.terrain.inland_water = scene::InlandWater::none;
  const image::Film film = shared_session().render(resolved(scene));
  for (const std::uint32_t id : film.object_id) {
    ASSERT_EQ(id, static_cast<std::uint32_t>(scene::ObjectId::terrain));
  }
}

}  // namespace
}  // namespace aerostat::test
