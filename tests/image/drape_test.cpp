// Tests that a picture on the ground is seen where it lies, as bright as it says.
#include "elevation/picture.hpp"
#include "flat_land.hpp"
#include "support/drape_files.hpp"

namespace aerostat::test {
namespace {

/// Level land of 100 m, under a picture whose quarters are red, green and blue, and transparent in
/// the south-east.
class DrapedLand : public testing::TestWithParam<scene::Integrator> {
 protected:
  scene::Scene draped() const {
    std::string heights = "ncols 12\nnrows 12\nxllcenter 499890\nyllcenter 5199890\ncellsize 20\n";
    for (int i = 0; i < 144; ++i) heights += "0 ";
    const auto land = folder_.write("land.asc", heights);
    const auto picture = folder_.write_png(
        "a.png", 100, 100,
        [](int i, int j) {
          return std::array{i < 50 && j < 50 ? 255 : 0, i >= 50 && j < 50 ? 255 : 0,
                            i < 50 && j >= 50 ? 255 : 0, i < 50 || j < 50 ? 255 : 0};
        },
        499950.0, 5200050.0, 1.0);
    scene::Scene scene = flat_land();
    scene.terrain.kind = scene::TerrainKind::elevation;
    scene.terrain.source = {land.string()};
    scene.terrain.crs = "EPSG:32632";
    scene.terrain.curved = false;
    scene.terrain.drape.file = picture.string();
    scene.terrain.drape.crs = "EPSG:32632";
    scene.sun.irradiance = 3.0;
    scene.sun.direction = {0.0, 1.0, 0.0};
    scene.light = GetParam();
    scene.bounces = 0;
    return scene;
  }

  DrapeFolder folder_;
};

TEST_P(DrapedLand, HasThePicturesColours) {
  scene::Scene scene = draped();
  const image::Film film = shared_session().render(resolved(scene));
  scene.terrain.drape.file = "";
  const image::Film bare = shared_session().render(resolved(scene));
  scene = draped();
  scene.terrain.drape.blend = 0.5;
  const image::Film half = shared_session().render(resolved(scene));
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * film.width + x); };
  const int x0 = film.width / 2 - 10, x1 = film.width / 2 + 9, y0 = film.height / 2 - 10,
            y1 = film.height / 2 + 9;
  const dvec3 ground = dvec3(bare.radiance[at(x0, y0)]);
  const dvec3 white = ground / kAlbedo * static_cast<double>(elevation::kWhiteAlbedo);
  expect_radiance(white * dvec3(1, 0, 0), dvec3(film.radiance[at(x0, y0)]), 5e-3);
  expect_radiance(white * dvec3(0, 1, 0), dvec3(film.radiance[at(x1, y0)]), 5e-3);
  expect_radiance(white * dvec3(0, 0, 1), dvec3(film.radiance[at(x0, y1)]), 5e-3);
  expect_radiance(ground, dvec3(film.radiance[at(x1, y1)]), 1e-6);
  expect_radiance(0.5 * (ground + white * dvec3(1, 0, 0)), dvec3(half.radiance[at(x0, y0)]), 5e-3);
}

INSTANTIATE_TEST_SUITE_P(ByIntegrator, DrapedLand,
                         testing::Values(scene::Integrator::local, scene::Integrator::path));

}  // namespace
}  // namespace aerostat::test
