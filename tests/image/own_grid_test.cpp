// Tests of maps in the grid of their elevation data, and of the GeoTIFF files that hold them.
#include "map/own_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "elevation/picture.hpp"
#include "land/grid_place.hpp"
#include "map/map_view.hpp"
#include "real_land.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::test {
namespace {

constexpr int kSamples = 101;
constexpr double kCell_m = 50.0;

/// Land of one height, with a gap in the sample 250 m to the east.
double plain_with_a_gap(double east, double north) {
  return std::hypot(east - 250.0, north) < 1.0 ? -9999.0 : 100.0;
}

/// A scene on flat land that is seen from straight above, turned by the given up vector.
scene::Scene seen_from_above(const std::filesystem::path& file, const dvec3& up) {
  write_land(file, kSamples, kCell_m, plain_with_a_gap);
  scene::Scene scene = bare_land(file, 8000.0, 64);
  scene.camera = {};
  scene.camera.lens = scene::Lens::orthographic;
  scene.camera.position = {400.0, 3000.0, -300.0};
  scene.camera.target = {400.0, 0.0, -300.0};
  scene.camera.up = up;
  scene.camera.view_height_m = 2000.0;
  scene.image.width = 80;
  scene.image.height = 60;
  return scene;
}

/// Returns a picture whose red and green say where each pixel lies: 1 for each 20 m from the
/// terrain's centre, from 128 on.
image::Pixels picture_of_places(const map::MapView& view, int width, int height) {
  image::Pixels picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const dvec2 point =
          view.corner + static_cast<double>(x) * view.right + static_cast<double>(y) * view.down;
      picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(128.0 + point.x / 20.0)));
      picture.rgb.push_back(static_cast<std::uint8_t>(std::lround(128.0 + point.y / 20.0)));
      picture.rgb.push_back(7);
    }
  }
  return picture;
}

struct Mapped {
  map::MapView view;
  map::OwnGrid grid;
  map::MapPixels pixels;
};

Mapped mapped(const scene::Scene& scene) {
  world::ReliefCache reliefs;
  const scene::ResolvedScene ready = resolved(scene);
  Mapped all;
  all.view = map::map_view(ready, {0.0, 0.0}, "--output");
  const auto [width, height] = std::pair(scene.image.width, scene.image.height);
  all.grid = map::own_grid(ready, all.view, width, height, "--output", reliefs);
  all.pixels = map::in_own_grid(picture_of_places(all.view, width, height), all.view, all.grid);
  return all;
}

/// Returns the places of all samples in the local frame, to the east and to the north.
std::vector<dvec2> places_of_samples(const map::OwnGrid& grid) {
  std::vector<dvec2> places;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) places.emplace_back(column, row);
  }
  land::grid_to_local(grid.georeference, grid.middle, places);
  for (dvec2& place : places) place.y = -place.y;
  return places;
}

// Tests that the pixel of a sample shows what lies at the sample's place, whatever is up in the
// picture.
TEST(OwnGrid, PutsEachPixelAtTheSampleOfItsPlace) {
  const TemporaryFolder folder;
  for (const dvec3& up : {dvec3(0.0, 0.0, -1.0), dvec3(0.6, 0.0, -0.8), dvec3(-1.0, 0.0, 0.0)}) {
    const Mapped all = mapped(seen_from_above(folder.path() / "plain.asc", up));
    const std::vector<dvec2> places = places_of_samples(all.grid);
    int shown = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const std::uint8_t* pixel = &all.pixels.rgba[4 * k];
      if (pixel[3] == 0) continue;
      ++shown;
      ASSERT_NEAR(pixel[0], 128.0 + places[k].x / 20.0, 1.1);
      ASSERT_NEAR(pixel[1], 128.0 + places[k].y / 20.0, 1.1);
      ASSERT_EQ(pixel[2], 7);
    }
    // The picture shows 2667 m x 2000 m, and a sample stands for 50 m x 50 m.
    EXPECT_NEAR(shown, 2667.0 * 2000.0 / 2500.0, 120.0);
  }
}

TEST(OwnGrid, ASampleWithoutAHeightIsTransparent) {
  const TemporaryFolder folder;
  const Mapped all = mapped(seen_from_above(folder.path() / "gap.asc", {0.0, 0.0, -1.0}));
  const std::vector<dvec2> places = places_of_samples(all.grid);
  int gaps = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (glm::length(places[k] - dvec2(400.0, 300.0)) > 900.0) continue;  // the picture's middle
    if (all.pixels.rgba[4 * k + 3] != 0) continue;
    ++gaps;
    EXPECT_NEAR(glm::length(places[k] - dvec2(250.0, 0.0)), 0.0, 1.0);
  }
  EXPECT_EQ(gaps, 1);
}

TEST(OwnGrid, RefusesAPictureBesideTheFile) {
  const TemporaryFolder folder;
  scene::Scene scene = seen_from_above(folder.path() / "plain.asc", {0.0, 0.0, -1.0});
  scene.camera.position->x = scene.camera.target->x = 50000.0;
  EXPECT_THROW(mapped(scene), Error);
}

// Tests that a file has the place and the colours of the map, for a system with an EPSG code and
// for one without, and for a grid that is turned.
TEST(GeoTiff, CanBeReadAgain) {
  const TemporaryFolder folder;
  map::MapPixels pixels{40, 30, {}};
  for (int i = 0; i < 40 * 30; ++i) {
    for (const int value : {i % 251, (7 * i) % 251, (3 * i) % 256, i == 35 ? 0 : 255}) {
      pixels.rgba.push_back(static_cast<std::uint8_t>(value));
    }
  }
  for (const char* crs :
       {"EPSG:32632", "EPSG:4326", "+proj=tmerc +lat_0=40 +lon_0=11 +datum=WGS84"}) {
    elevation::Georeference place{crs, {10.5, 40.25}, {0.5, 0.0}, {0.0, -0.25}};
    if (std::string(crs) == "EPSG:32632") {
      place = {crs, {500010.0, 5200020.0}, {30.0, 4.0}, {4.0, -30.0}};
    }
    const auto bytes = map::encode_geotiff(pixels, place);
    const auto file = folder.path() / "map.tif";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    const auto read = elevation::open_picture(file, {});
    ASSERT_TRUE(read->info().georeference);
    const elevation::Georeference& found = *read->info().georeference;
    EXPECT_NEAR(glm::length(found.origin - place.origin), 0.0, 1e-6);
    EXPECT_NEAR(glm::length(found.per_column - place.per_column), 0.0, 1e-9);
    EXPECT_NEAR(glm::length(found.per_row - place.per_row), 0.0, 1e-9);
    EXPECT_EQ(geo::crs_info(found.crs).geographic, geo::crs_info(crs).geographic);
    const geo::Place here = geo::place_of(crs, place.origin);
    const geo::Place there = geo::place_of(found.crs, found.origin);
    EXPECT_NEAR(here.latitude_deg, there.latitude_deg, 1e-7) << crs;
    EXPECT_NEAR(here.longitude_deg, there.longitude_deg, 1e-7) << crs;
    ASSERT_EQ(read->levels()[0], (std::array<int, 2>{40, 30}));
    std::vector<elevation::vec4> colours(40 * 30);
    read->read(0, {0, 0, 40, 30}, colours.data());
    EXPECT_EQ(colours[35].w, 0.0f);
    EXPECT_EQ(colours[36].w, 1.0f);
    EXPECT_GT(colours[250].x, colours[251].x);
  }
}

}  // namespace
}  // namespace aerostat::test
