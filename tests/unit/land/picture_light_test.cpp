// Tests that the light and shade of a picture of land are found and taken out.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "geo/transform.hpp"
#include "land/drape.hpp"
#include "support/drape_files.hpp"

namespace aerostat::land {
namespace {

constexpr const char* kUtm = "EPSG:32632";
constexpr double kEast = 500000.0, kNorth = 5200000.0;  // on the central meridian
constexpr double kHalf_m = 2000.0, kCell_m = 25.0, kPixel_m = 12.5;
constexpr int kPixels = 320;
constexpr double kSunAzimuth_deg = 140.0, kSunElevation_deg = 35.0;
const vec3 kSky(0.2f, 0.25f, 0.35f);  // of the light of level ground in full shade

/// The height of steep hills and ridges at metres to the east and to the south.
double hills(double east, double south) {
  return 1000.0 + 260.0 * std::sin(east / 310.0) * std::cos(south / 370.0) +
         90.0 * std::sin((east + 0.6 * south) / 170.0);
}

/// Returns the sun's light relative to that on level ground, by the formula of the hills.
double sun_on_hills(double east, double south) {
  const double azimuth = glm::radians(kSunAzimuth_deg);
  const double rise = std::tan(glm::radians(kSunElevation_deg));
  const dvec2 towards(std::sin(azimuth), -std::cos(azimuth));
  const double height = hills(east, south);
  for (double way = 5.0; way < 1500.0; way += 5.0) {
    const double ray = height + way * rise;
    if (hills(east + way * towards.x, south + way * towards.y) > ray) return 0.0;
  }
  const dvec2 slope((hills(east + 1.0, south) - hills(east - 1.0, south)) / 2.0,
                    (hills(east, south + 1.0) - hills(east, south - 1.0)) / 2.0);
  const double facing =
      (1.0 - glm::dot(slope, towards) / rise) / std::sqrt(1.0 + glm::dot(slope, slope));
  return std::max(facing, 0.0);
}

/// The true albedo: fields of two greens and a grey, 150 m wide.
vec3 albedo_at(double east, double south) {
  const int field = static_cast<int>(std::floor(east / 150.0) + 3.0 * std::floor(south / 150.0));
  switch (((field % 3) + 3) % 3) {
    case 0:
      return {0.10f, 0.14f, 0.06f};
    case 1:
      return {0.14f, 0.17f, 0.08f};
    default:
      return {0.16f, 0.15f, 0.13f};
  }
}

int srgb_byte(double linear) {
  const double share = linear / elevation::kWhiteAlbedo;
  const double s = share <= 0.0031308 ? 12.92 * share : 1.055 * std::pow(share, 1.0 / 2.4) - 0.055;
  return static_cast<int>(std::lround(255.0 * std::min(std::max(s, 0.0), 1.0)));
}

class PictureLightTest : public ::testing::Test {
 protected:
  PictureLightTest() {
    std::ostringstream text;
    const int side = static_cast<int>(2.0 * kHalf_m / kCell_m) + 1;
    text << "ncols " << side << "\nnrows " << side << "\nxllcenter " << kEast - kHalf_m
         << "\nyllcenter " << kNorth - kHalf_m << "\ncellsize " << kCell_m << "\n";
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        text << hills(i * kCell_m - kHalf_m, j * kCell_m - kHalf_m) << '\n';
    LandOptions land;
    land.sources = {folder_.write("hills.asc", text.str())};
    land.open.crs = kUtm;
    options_.land = std::make_shared<const Land>(land);
    options_.picture.crs = kUtm;
    options_.middle.place = geo::place_of(kUtm, {kEast, kNorth});
    options_.reach_m = 2.0 * kHalf_m;
  }

  /// Draws the picture as it looks in the sun, or without light and shade.
  void draw(bool lit) {
    options_.file = folder_.write_png(
        "ortho.png", kPixels, kPixels,
        [lit](int i, int j) {
          const double east = (i + 0.5) * kPixel_m - kHalf_m,
                       south = (j + 0.5) * kPixel_m - kHalf_m;
          const vec3 light =
              lit ? kSky + (1.0f - kSky) * static_cast<float>(sun_on_hills(east, south))
                  : vec3(1.0f);
          const vec3 colour = albedo_at(east, south) * light;
          return std::array{srgb_byte(colour.x), srgb_byte(colour.y), srgb_byte(colour.z), 255};
        },
        kEast - kHalf_m, kNorth + kHalf_m, kPixel_m);
  }

  /// Returns the root mean square of the logarithm of a drape's colour over the true albedo, away
  /// from the rim of the picture.
  static double error(const Drape& drape) {
    double sum = 0.0;
    int count = 0;
    for (double east = -1500.0; east < 1500.0; east += 37.0)
      for (double south = -1500.0; south < 1500.0; south += 41.0) {
        const vec3 found(drape.at(east, south, kPixel_m)), truth = albedo_at(east, south);
        for (int c = 0; c < 3; ++c) {
          const double off = std::log(std::max(found[c], 1e-3f) / truth[c]);
          sum += off * off;
          ++count;
        }
      }
    return std::sqrt(sum / count);
  }

  test::DrapeFolder folder_;
  DrapeOptions options_;
};

TEST_F(PictureLightTest, IsFoundAndTakenOut) {
  draw(true);
  const double before = error(Drape(options_));
  options_.lift_shadows = 1.0;
  const Drape lifted(options_);
  ASSERT_EQ(lifted.notes().size(), 1u);
  int azimuth = 0, elevation = 0;
  const std::string& note = lifted.notes()[0];
  const std::size_t at = note.find("azimuth");
  ASSERT_NE(at, std::string::npos) << note;
  ASSERT_EQ(std::sscanf(note.c_str() + at, "azimuth %d and %d degrees", &azimuth, &elevation), 2);
  EXPECT_NEAR(azimuth, kSunAzimuth_deg, 4.0) << note;
  EXPECT_NEAR(elevation, kSunElevation_deg, 4.0) << note;
  EXPECT_GT(before, 0.5);
  EXPECT_LT(error(lifted), 0.2 * before) << note;
  options_.lift_shadows = 0.5;
  const double half = error(Drape(options_));
  EXPECT_LT(half, 0.8 * before);
  EXPECT_GT(half, error(lifted));
}

TEST_F(PictureLightTest, WithoutLightAndShadeThePictureStays) {
  draw(false);
  const double before = error(Drape(options_));
  options_.lift_shadows = 1.0;
  const Drape same(options_);
  ASSERT_EQ(same.notes().size(), 1u);
  EXPECT_NE(same.notes()[0].find("no light and shade"), std::string::npos) << same.notes()[0];
  EXPECT_EQ(error(same), before);
}

}  // namespace
}  // namespace aerostat::land
