// Tests that names of places point to the pixels in which those places are rendered, and that what
// the land hides is hidden.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "labels/names_in_view.hpp"
#include "map/map_frame.hpp"
#include "real_land.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::test {
namespace {

constexpr double kCell = 50.0, kSize_m = 9000.0;

/// Ridges that run from west to east, and hills that tell places along them apart.
double ridges(double east, double north) {
  return 800.0 + 250.0 * std::cos(north / 350.0) + 80.0 * std::sin(east / 270.0);
}

scene::Scene land_of_ridges(const std::filesystem::path& folder) {
  write_land(folder / "ridges.asc", 201, kCell, ridges);
  scene::Scene scene = bare_land(folder / "ridges.asc", kSize_m, 720);
  scene.camera = {};
  scene.camera.position = {300.0, 1250.0, 2600.0};
  scene.camera.target = {0.0, 900.0, 0.0};
  scene.image.width = 240;
  scene.image.height = 160;
  return scene;
}

/// Returns places on a lattice over the land.
std::vector<labels::NamedPlace> places_on_land() {
  const geo::Place middle = geo::place_of(kCrs, kMiddle);
  std::vector<labels::NamedPlace> places;
  for (double z = -3900.0; z <= 3900.0; z += 173.0) {
    for (double x = -3900.0; x <= 3900.0; x += 211.0) {
      places.push_back({"place", geo::place_of_local(middle, {x, z}), {}});
    }
  }
  return places;
}

struct Span {
  double nearest, farthest;
};

/// Returns the distances in the pixels around one, those beyond the picture left out.
Span around(const image::Film& film, const dvec2& pixel) {
  Span span{1e30, 0.0};
  const int x = static_cast<int>(pixel.x), y = static_cast<int>(pixel.y);
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, film.height - 1); ++j) {
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, film.width - 1); ++i) {
      const double distance = film.distance_m[static_cast<std::size_t>(j * film.width + i)];
      span.nearest = std::min(span.nearest, distance);
      span.farthest = std::max(span.farthest, distance);
    }
  }
  return span;
}

class LabelLens : public testing::TestWithParam<scene::Lens> {};

// Tests each place in the picture: one in sight has the distance of the pixels around, and one that
// is hidden is farther than they are. The land is drawn by flat cells, so that some places at the
// rims of ridges are on the wrong side by a few metres.
TEST_P(LabelLens, PlacesAreWhereTheyAreRendered) {
  const TemporaryFolder folder;
  scene::Scene scene = land_of_ridges(folder.path());
  scene.camera.lens = GetParam();
  if (GetParam() == scene::Lens::orthographic) scene.camera.view_height_m = 2500.0;
  if (GetParam() == scene::Lens::thin_lens) scene.camera.aperture_m = 1e-6;
  if (GetParam() == scene::Lens::panorama) scene.image.width = 320;
  const scene::ResolvedScene seen = resolved(scene);
  const image::Film film = shared_session().render(seen);
  world::ReliefCache reliefs;
  int in_sight = 0, hidden = 0, wrong = 0;
  for (const labels::NameInView& name : labels::names_in_view(places_on_land(), seen, reliefs)) {
    if (!name.in_picture) continue;
    const Span span = around(film, *name.pixel);
    ++(name.hidden ? hidden : in_sight);
    const double slack = 5.0 + 0.003 * name.distance_m;
    const bool is_right = name.hidden ? span.nearest < name.distance_m
                                      : span.nearest - slack < name.distance_m &&
                                            name.distance_m < span.farthest + slack;
    wrong += is_right ? 0 : 1;
  }
  EXPECT_GT(in_sight, 100);
  EXPECT_GT(hidden, 100);
  EXPECT_LE(wrong, (in_sight + hidden) / 100) << in_sight << " in sight, " << hidden << " hidden";
}

INSTANTIATE_TEST_SUITE_P(OfEachKind, LabelLens,
                         testing::Values(scene::Lens::pinhole, scene::Lens::thin_lens,
                                         scene::Lens::panorama, scene::Lens::orthographic));

TEST(Labels, APeakBehindARidgeIsHidden) {
  const TemporaryFolder folder;
  scene::Scene scene = land_of_ridges(folder.path());
  // From a little below the height of the next crest, the crest is in sight, and the valley behind
  // it is not.
  const double pi = 3.14159265358979;
  scene.camera.position = {0.0, 1045.0, 350.0 * pi};
  scene.camera.target = {0.0, 1045.0, -2000.0};
  const geo::Place middle = geo::place_of(kCrs, kMiddle);
  const auto at = [&](double z) { return geo::place_of_local(middle, {0.0, z}); };
  world::ReliefCache reliefs;
  const auto names = labels::names_in_view({{"crest", at(0.0), {}},
                                            {"valley", at(-350.0 * pi), {}},
                                            {"behind", at(3000.0), {}},
                                            {"tower", at(-350.0 * pi), 2000.0}},
                                           resolved(scene), reliefs);
  EXPECT_FALSE(names[0].hidden);
  EXPECT_TRUE(names[0].in_picture);
  EXPECT_TRUE(names[1].hidden);
  EXPECT_TRUE(names[2].hidden);
  EXPECT_FALSE(names[2].pixel);
  EXPECT_FALSE(names[3].hidden);
  EXPECT_NEAR(names[3].height_m, 2000.0, 1e-9);
}

// Tests that the world file leads from the pixel of a place to the coordinates of the place.
TEST(MapFrame, LeadsFromPixelsToTheLocalFrame) {
  const TemporaryFolder folder;
  scene::Scene scene = land_of_ridges(folder.path());
  scene.terrain.center = {100.0, -50.0};
  scene.camera.lens = scene::Lens::orthographic;
  scene.camera.position = {200.0, 3000.0, 300.0};
  scene.camera.target = {200.0, 0.0, 300.0};
  scene.camera.up = {0.6, 0.0, -0.8};
  scene.camera.view_height_m = 4000.0;
  world::ReliefCache reliefs;
  const map::MapFrame frame = map::map_frame(resolved(scene), {7.0, 3.0}, reliefs);
  std::istringstream numbers(frame.world_file);
  dvec2 right, down, corner;
  numbers >> right.x >> right.y >> down.x >> down.y >> corner.x >> corner.y;
  ASSERT_TRUE(numbers);
  const geo::Place middle = geo::place_of(kCrs, kMiddle);
  const auto names = labels::names_in_view(
      {{"place", geo::place_of_local(middle, {350.0, -800.0}), {}}}, resolved(scene), reliefs);
  const dvec2 pixel = *names[0].pixel - dvec2(7.5, 3.5);
  const dvec2 found = corner + pixel.x * right + pixel.y * down;
  EXPECT_NEAR(found.x, 350.0, 0.01);
  EXPECT_NEAR(found.y, 800.0, 0.01);
  EXPECT_NE(frame.crs.find("PROJECTION[\"Transverse_Mercator\"]"), std::string::npos);
  scene.camera.target->x += 1.0;
  EXPECT_THROW(map::map_frame(resolved(scene), {0.0, 0.0}, reliefs), Error);
}

TEST(Labels, NeedLandThatLiesOnTheEarth) {
  world::ReliefCache reliefs;
  const scene::Scene scene = small_scene("snow");
  EXPECT_THROW(labels::names_in_view(places_on_land(), resolved(scene), reliefs), Error);
}

}  // namespace
}  // namespace aerostat::test
