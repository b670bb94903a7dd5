// Tests that the land of a file stands where and as high as the file says: heights from straight
// above, and summits by azimuth and elevation over the curved Earth.
#include "real_land.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "geo/transform.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::test {
namespace {

constexpr double kPi = std::numbers::pi;

constexpr double kWaveHeight = 60.0, kColumnWave = 12.0, kRowWave = 16.0;  // waves in samples

double waves(double column, double row) {
  return 1000.0 + kWaveHeight * std::sin(2.0 * kPi / kColumnWave * column) *
                      std::cos(2.0 * kPi / kRowWave * row);
}

// Tests heights against waves in closed form. Their crests lie on samples. A cubic spline through
// samples follows a function f within 5/384 of its fourth derivative, and flat cells of m samples
// follow the spline within m^2 / 8 of its second derivatives. Both are taken along both axes.
TEST(RealLand, HasTheHeightsOfTheFileFromAbove) {
  const TemporaryFolder folder;
  constexpr double cell = 30.0;
  write_land(folder.path() / "waves.asc", 97, cell,
             [](double east, double north) { return waves(east / cell, north / cell); });
  scene::Scene scene = bare_land(folder.path() / "waves.asc", 2000.0, 256);
  scene.terrain.curved = false;
  scene.camera = {};
  scene.camera.lens = scene::Lens::orthographic;
  scene.camera.position = {0.0, 3000.0, 0.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.camera.view_height_m = 1600.0;
  scene.image.width = scene.image.height = 128;
  const image::Film film = shared_session().render(resolved(scene));

  const double a = 2.0 * kPi / kColumnWave, b = 2.0 * kPi / kRowWave;
  const double mesh = 2000.0 / 256 / cell;
  const double bound = kWaveHeight * (5.0 / 384.0 * (a * a * a * a + b * b * b * b) +
                                      mesh * mesh / 8.0 * (a * a + b * b)) +
                       0.01;
  double largest = 0.0;
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const auto i = static_cast<std::size_t>(y * film.width + x);
      const double pixel = 1600.0 / film.height * kUtmScale / cell;
      const double expected =
          waves((x + 0.5 - 0.5 * film.width) * pixel, (0.5 * film.height - y - 0.5) * pixel);
      largest = std::max(largest, std::fabs(3000.0 - film.distance_m[i] - expected));
    }
  }
  EXPECT_LT(largest, bound);
  EXPECT_GT(largest, 0.0);
}

struct Seen {
  double azimuth_rad, elevation_rad, distance_m;
};

/// Returns where a summit is seen from an eye, by the formulas of the mean latitude on the
/// ellipsoid WGS 84 and on a sphere that is larger than the Earth by refraction.
Seen seen_from(const geo::Place& eye, double eye_m, const geo::Place& summit, double summit_m) {
  constexpr double a = 6378137.0, e2 = 0.00669437999014, degree = kPi / 180.0;
  const double middle = 0.5 * (eye.latitude_deg + summit.latitude_deg) * degree;
  const double w = 1.0 - e2 * std::sin(middle) * std::sin(middle);
  const double turn = (summit.longitude_deg - eye.longitude_deg) * degree;
  const double north =
      a * (1.0 - e2) / (w * std::sqrt(w)) * (summit.latitude_deg - eye.latitude_deg) * degree;
  const double east = a / std::sqrt(w) * std::cos(middle) * turn;
  const double distance = std::hypot(north, east);
  constexpr double radius = 6371008.8 / (1.0 - 0.13);
  const double angle = distance / radius;
  return {std::atan2(east, north) - 0.5 * turn * std::sin(middle),
          std::atan2((radius + summit_m) * std::cos(angle) - radius - eye_m,
                     (radius + summit_m) * std::sin(angle)),
          distance};
}

/// Returns the top row of the land in each column. The picture's height stands for no land.
std::vector<int> skyline(const image::Film& film) {
  std::vector<int> tops;
  for (int x = 0; x < film.width; ++x) {
    int y = 0;
    while (y < film.height &&
           std::isinf(film.distance_m[static_cast<std::size_t>(y * film.width + x)])) {
      ++y;
    }
    tops.push_back(y);
  }
  return tops;
}

constexpr double kEye_m = 900.0, kPlain_m = 400.0, kWidth_m = 1000.0;

/// Summits by distance, azimuth in the file's grid, and height.
struct Summit {
  double distance_m, azimuth_deg, height_m;

  dvec2 place() const {
    const double turn = azimuth_deg * kPi / 180.0;
    // On a node of the file, so that no sample is higher.
    return {std::round(distance_m * std::sin(turn) / 100.0) * 100.0,
            std::round(distance_m * std::cos(turn) / 100.0) * 100.0};
  }
};
// The nearest one is hardly higher than the eye: the outline of a dome seen from below is higher
// than its summit.
constexpr Summit kSummits[] = {
    {5000.0, 35.0, 950.0}, {20000.0, 130.0, 2100.0}, {45000.0, 250.0, 3300.0}};

double with_summits(double east, double north) {
  double height = kPlain_m;
  for (const Summit& summit : kSummits) {
    const dvec2 from = (dvec2(east, north) - summit.place()) / kWidth_m;
    height += (summit.height_m - kPlain_m) * std::exp(-0.5 * glm::dot(from, from));
  }
  return height;
}

// Tests summits in pictures of 2 degrees, in which a pixel is 0.0125 degrees: 1.1 m at the nearest
// summit and 10 m at the farthest, which the Earth lowers by 138 m and refraction raises by 21 m.
TEST(RealLand, SummitsAppearAtTheAzimuthAndElevationOfGeometry) {
  const TemporaryFolder folder;
  write_land(folder.path() / "summits.asc", 1001, 100.0, with_summits);
  scene::Scene scene = bare_land(folder.path() / "summits.asc", 96000.0, 1536);
  scene.haze.visibility_m = 1e6;
  scene.image.width = 400;
  scene.image.height = 160;
  scene.camera = {};
  scene.camera.fov_y_deg = 2.0;
  scene.camera.position = {0.0, kEye_m, 0.0};
  const geo::Place eye = geo::place_of(kCrs, kMiddle);
  for (const Summit& summit : kSummits) {
    SCOPED_TRACE(summit.distance_m);
    const Seen seen =
        seen_from(eye, kEye_m, geo::place_of(kCrs, kMiddle + summit.place()), summit.height_m);
    const double level = 1000.0 * std::cos(seen.elevation_rad);
    scene.camera.target = *scene.camera.position + dvec3(level * std::sin(seen.azimuth_rad),
                                                         1000.0 * std::sin(seen.elevation_rad),
                                                         -level * std::cos(seen.azimuth_rad));
    const std::vector<int> tops = skyline(shared_session().render(resolved(scene)));
    // The summit is expected in the middle of the picture: at the upper edge of row 80.
    const int top = *std::min_element(tops.begin(), tops.end());
    EXPECT_NEAR(top, 80.0, 1.0);
    // The mountain is symmetric: its middle lies between equally high points of its outline.
    int left = 0, right = static_cast<int>(tops.size()) - 1;
    while (tops[static_cast<std::size_t>(left)] > top + 3) ++left;
    while (tops[static_cast<std::size_t>(right)] > top + 3) --right;
    EXPECT_NEAR(0.5 * (left + right + 1), 200.0, 1.0);
    EXPECT_GT(left, 0) << "the outline leaves the picture";
  }
}

}  // namespace
}  // namespace aerostat::test
