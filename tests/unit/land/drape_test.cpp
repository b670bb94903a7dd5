#include "land/drape.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "geo/transform.hpp"
#include "support/drape_files.hpp"
#include "unit/elevation/tiff_files.hpp"

namespace aerostat::land {
namespace {

constexpr const char* kUtm = "EPSG:32632";
constexpr double kEast = 500000.0, kNorth = 5200000.0;  // on the central meridian

class DrapeTest : public ::testing::Test {
 protected:
  /// Writes a picture of 200 x 100 pixels of 10 m, whose middle is the middle of the frame.
  void write(const test::PixelAt& pixel_at) {
    options_.file =
        folder_.write_png("a.png", 200, 100, pixel_at, kEast - 1000.0, kNorth + 500.0, 10.0);
    options_.picture.crs = kUtm;
    options_.middle.place = geo::place_of(kUtm, {kEast, kNorth});
    options_.reach_m = 20000.0;
  }

  std::string error() const {
    try {
      const Drape drape(options_);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  test::DrapeFolder folder_;
  DrapeOptions options_;
};

std::array<int, 4> grey(int, int) {
  return {128, 128, 128, 255};
}

TEST_F(DrapeTest, ATexelKeepsItsColour) {
  for (const vec4 colour :
       {vec4(0.0f), vec4(0.3f, 0.02f, 0.85f, 1.0f), vec4(0.1f, 0.2f, 0.3f, 0.5f)}) {
    const vec4 kept = colour_of_texel(packed_texel(colour));
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(kept[k], colour[k], 0.004f);
  }
}

TEST_F(DrapeTest, WhiteIsAsBrightAsFreshSnow) {
  write([](int, int) { return std::array{255, 255, 255, 255}; });
  const vec4 white = Drape(options_).at(0.0, 0.0, 1.0);
  EXPECT_NEAR(white.x, elevation::kWhiteAlbedo, 0.004f);
  EXPECT_EQ(white.w, 1.0f);
}

TEST_F(DrapeTest, APixelLiesAtItsPlace) {
  // The pixel in column 150 and row 20 is 505 m to the east and 295 m to the north of the middle.
  write([](int i, int j) {
    return i == 150 && j == 20 ? std::array{255, 0, 0, 255} : std::array{0, 0, 255, 255};
  });
  const Drape drape(options_);
  EXPECT_GT(drape.at(505.2, -295.1, 1.0).x, 0.6f);
  for (const dvec2 other :
       {dvec2(-505.0, -295.0), dvec2(505.0, 295.0), dvec2(525.0, -295.0), dvec2(505.0, -275.0)}) {
    EXPECT_LT(drape.at(other.x, other.y, 1.0).x, 0.02f);
  }
}

TEST_F(DrapeTest, WideFootprintsKeepTheMean) {
  write([](int i, int j) {
    return (i + j) % 2 == 0 ? std::array{255, 255, 255, 255} : std::array{0, 0, 0, 255};
  });
  const Drape drape(options_);
  for (const double footprint : {40.0, 100.0, 300.0}) {
    EXPECT_NEAR(drape.at(12.0, 34.0, footprint).x, 0.5f * elevation::kWhiteAlbedo, 0.01f)
        << footprint;
  }
}

TEST_F(DrapeTest, WhatIsTransparentHasNoColour) {
  // The colour below a transparent pixel must not bleed into its neighbours.
  write([](int i, int j) {
    return (i + j) % 2 == 0 ? std::array{255, 0, 0, 0} : std::array{0, 255, 0, 255};
  });
  const Drape drape(options_);
  for (const double footprint : {1.0, 80.0}) {
    const vec4 found = drape.at(12.0, 34.0, footprint);
    EXPECT_LT(found.x, 0.001f);
    EXPECT_NEAR(found.y, found.w * elevation::kWhiteAlbedo, 0.01f);
  }
  EXPECT_NEAR(drape.at(12.0, 34.0, 80.0).w, 0.5f, 0.01f);
}

TEST_F(DrapeTest, NothingLiesOutside) {
  write(grey);
  const Drape drape(options_);
  EXPECT_EQ(drape.at(990.0, 0.0, 1.0).w, 1.0f);
  for (const dvec2 beyond :
       {dvec2(1015.0, 0.0), dvec2(0.0, 515.0), dvec2(-19000.0, 0.0), dvec2(0.0, 1e6)}) {
    EXPECT_EQ(drape.at(beyond.x, beyond.y, 1.0).w, 0.0f);
  }
}

TEST_F(DrapeTest, APictureBesideTheMiddleIsAsFineAsItsFile) {
  write([](int i, int) {
    return i % 2 == 0 ? std::array{255, 255, 255, 255} : std::array{0, 0, 0, 255};
  });
  options_.middle.place = geo::place_of(kUtm, {kEast - 8000.0, kNorth});
  const Drape drape(options_);
  EXPECT_NEAR(drape.texel_m(), 10.0, 0.1);
  // The first column is 7005 m to the east.
  EXPECT_GT(drape.at(7005.0, 0.0, 1.0).x - drape.at(7015.0, 0.0, 1.0).x, 0.3f);
}

TEST_F(DrapeTest, ALevelGivesWayWithoutAStep) {
  write([](int i, int) { return std::array{i, i, i, 255}; });
  const Drape drape(options_);
  float before = drape.at(-950.0, 0.0, 1.0).x;
  for (double east = -949.0; east < 950.0; east += 1.0) {
    const float now = drape.at(east, 0.0, 1.0 + 0.05 * (east + 950.0)).x;
    EXPECT_NEAR(now, before, 0.008f) << east;
    before = now;
  }
}

TEST_F(DrapeTest, TellsWhatIsGuessedAboutItsFile) {
  write(grey);
  EXPECT_TRUE(Drape(options_).notes().empty());
  elevation::TiffPageSpec page = elevation::page_at(32632, kEast, kNorth, 2.0);
  page.bits = 8;
  page.format = 1;
  page.bands = 3;
  page.photometric = 2;  // RGB
  page.pixel_scale = page.tiepoints = {};
  options_.file = folder_.write("b.tfw", "2\n0\n0\n-2\n500001\n5199999\n");
  options_.file.replace_extension(".tif");
  options_.picture.crs = "";
  elevation::write_tiff(options_.file, {page});
  EXPECT_EQ(
      Drape(options_).notes(),
      std::vector<std::string>{"b.tif: The place of the file is from the world file beside it."});
}

TEST_F(DrapeTest, AFileThatIsMissingIsNamed) {
  write(grey);
  options_.file = "nowhere/ortho.png";
  EXPECT_NE(error().find("nowhere/ortho.png"), std::string::npos);
}

TEST_F(DrapeTest, APictureWithoutAPlaceNamesTheOption) {
  write(grey);
  std::filesystem::remove(std::filesystem::path(options_.file).replace_extension(".pgw"));
  EXPECT_NE(error().find("/terrain/drape/corners"), std::string::npos) << error();
  const geo::Place middle = *options_.middle.place;
  options_.picture.corners = {
      geo::Place{middle.latitude_deg + 0.0045, middle.longitude_deg - 0.0131},
      geo::Place{middle.latitude_deg - 0.0045, middle.longitude_deg + 0.0131}};
  EXPECT_EQ(Drape(options_).at(900.0, 400.0, 1.0).w, 1.0f);
}

TEST_F(DrapeTest, APictureWithoutASystemNamesTheOption) {
  write(grey);
  options_.picture.crs = "";
  EXPECT_NE(error().find("/terrain/drape/crs"), std::string::npos) << error();
}

TEST_F(DrapeTest, AWrongSystemIsNoticed) {
  write(grey);
  options_.picture.crs = "EPSG:4326";
  EXPECT_NE(error().find("/terrain/drape/crs"), std::string::npos) << error();
  options_.picture.crs = "EPSG:32610";  // the same numbers in America
  EXPECT_NE(error().find("does not lie on the land"), std::string::npos) << error();
}

TEST_F(DrapeTest, LevelsAreBounded) {
  write(grey);
  options_.reach_m = 500000.0;
  const Drape drape(options_);
  EXPECT_LE(drape.levels(), kMostDrapeLevels);
  EXPECT_LE(drape.side(), kMostDrapeSide);
  EXPECT_EQ(drape.texels().size(), static_cast<std::size_t>(drape.levels()) *
                                       static_cast<std::size_t>(drape.side() * drape.side()));
}

}  // namespace
}  // namespace aerostat::land
