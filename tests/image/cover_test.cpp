// Tests that land cover colours the ground where it says.
#include <cstddef>

#include "real_land.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::test {
namespace {

/// A level plain, seen from straight above, whose north-west is built up and whose north-east is
/// under snow by land cover.
scene::Scene covered_plain(const TemporaryFolder& folder) {
  const auto heights = folder.path() / "land.asc", codes = folder.path() / "cover.asc";
  write_land(heights, 41, 30.0, [](double, double) { return 100.0; });
  write_land(codes, 41, 30.0, [](double east, double north) {
    return north < 0.0 ? 0.0 : east < 0.0 ? 50.0 : 70.0;
  });
  scene::Scene scene = bare_land(heights, 1000.0, 64);
  scene.terrain.cover.source = codes.string();
  scene.terrain.cover.crs = kCrs;
  scene.terrain.cover.scheme = CoverScheme::worldcover;
  scene.terrain.cover.classes = {{0, CoverClass::meadow}};
  scene.biome.ground.snow_line_m = 1e6;
  scene.camera = {};
  scene.camera.lens = scene::Lens::orthographic;
  scene.camera.position = {0.0, 2000.0, 0.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.camera.view_height_m = 800.0;
  scene.image.width = scene.image.height = 64;
  return scene;
}

double brightness(const image::Film& film, int x, int y) {
  dvec3 sum(0.0);
  for (int j = y; j < y + 8; ++j)
    for (int i = x; i < x + 8; ++i) {
      sum += dvec3(film.radiance[static_cast<std::size_t>(j * film.width + i)]);
    }
  return sum.x + sum.y + sum.z;
}

TEST(Cover, ColoursTheGroundByItsClasses) {
  const TemporaryFolder folder;
  scene::Scene scene = covered_plain(folder);
  const image::Film film = shared_session().render(resolved(scene));
  const double built_up = brightness(film, 8, 8), snow = brightness(film, 48, 8);
  EXPECT_GT(snow, 2.5 * built_up);
  EXPECT_LT(snow, 8.0 * built_up);
  scene.terrain.cover.source.clear();
  const image::Film bare = shared_session().render(resolved(scene));
  EXPECT_LT(brightness(bare, 48, 8), 0.6 * snow);
}

}  // namespace
}  // namespace aerostat::test
