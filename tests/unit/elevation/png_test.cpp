// The traps of heights in PNG images: range, distance, depth, colours, tiles.

#include "elevation/png.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "elevation/web_tile.hpp"
#include "files.hpp"
#include "png_file.hpp"

namespace aerostat::elevation {
namespace {

OpenOptions said(double low, double high, double cell_m) {
  OpenOptions options;
  options.image_heights_m = {low, high};
  options.cell_m = cell_m;
  return options;
}

/// Returns the colours of a hill of 256 x 256 pixels.
std::vector<int> hill(const TileEncoding& encoding, int channels, int side = 256) {
  std::vector<int> values;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const double height = 1500.0 + 900.0 * std::sin(0.02 * i) * std::cos(0.03 * j);
      const int value = static_cast<int>(std::lround((height - encoding.base_m) / encoding.step_m));
      values.insert(values.end(), {value >> 16 & 255, value >> 8 & 255, value & 255});
      if (channels == 4) values.push_back(255);
    }
  }
  return values;
}

TEST(Png, GreyOf16BitsIsBigEndianAndHasTheRangeOfTheUser) {
  const Folder folder;
  const auto path = folder.write("a.png", png(2, 2, 16, 0, {0, 65535, 256, 1}));
  const auto raster = open(path, said(-100.0, 65435.0, 20.0));
  EXPECT_EQ(heights_of(*raster), (std::vector<float>{-100.0f, 65435.0f, 156.0f, -99.0f}));
  EXPECT_EQ(raster->info().sample_type, "uint16");
  EXPECT_EQ(raster->info().georeference->per_row, dvec2(0.0, -20.0));
  EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(-10.0, 10.0));
  EXPECT_TRUE(raster->info().notes.empty());
}

TEST(Png, WithoutRangeOrDistanceTheOptionsAreNamed) {
  const Folder folder;
  const auto path = folder.write("a.png", png(2, 2, 16, 0, {0, 65535, 256, 1}));
  const std::string none = refusal_of([&] { open(path); });
  EXPECT_TRUE(says(none, "/terrain/image_heights_m"));
  EXPECT_TRUE(says(none, "/terrain/cell_m"));
  OpenOptions options;
  options.image_heights_m = {0.0, 100.0};
  EXPECT_TRUE(says(refusal_of([&] { open(path, options); }), "/terrain/cell_m"));
  EXPECT_TRUE(says(refusal_of([&] { open(path, said(5.0, 5.0, 1.0)); }), "the lower height"));
  EXPECT_TRUE(says(refusal_of([&] { open(path, said(0.0, 5.0, -1.0)); }), "-1 m apart"));
}

TEST(Png, EightBitsAreSaidToBeCoarse) {
  const Folder folder;
  const auto path = folder.write("a.png", png(2, 2, 8, 0, {0, 255, 1, 2}));
  const auto raster = open(path, said(0.0, 2817.0, 30.0));
  EXPECT_FLOAT_EQ(height_at(*raster, 0, 1), 2817.0f / 255.0f);
  EXPECT_TRUE(has_note(*raster, "steps of 11 m"));
  const auto widened = folder.write("b.png", png(2, 2, 16, 0, {0, 65535, 257, 514}));
  EXPECT_TRUE(has_note(*open(widened, said(0.0, 2817.0, 30.0)), "steps of 11 m"));
  const auto colours =
      folder.write("c.png", png(2, 2, 8, 2, {0, 0, 0, 255, 255, 255, 1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(heights_of(*open(colours, said(0.0, 255.0, 30.0))), (std::vector<float>{0, 255, 1, 2}));
}

TEST(Png, TransparentPixelsAndTheMarkAreVoids) {
  const Folder folder;
  const auto path =
      folder.write("a.png", png(2, 2, 16, 4, {0, 65535, 7, 0, 256, 65535, 65535, 65535}));
  OpenOptions options = said(0.0, 65535.0, 1.0);
  const auto raster = open(path, options);
  EXPECT_EQ(height_at(*raster, 0, 0), 0.0f);
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 0)));
  options.nodata = 65535.0;
  EXPECT_TRUE(std::isnan(height_at(*open(path, options), 1, 1)));
}

TEST(Png, AWorldFileGivesThePlaceEvenRotated) {
  const Folder folder;
  const auto path = folder.write("a.png", png(2, 2, 16, 0, {0, 65535, 256, 1}));
  folder.write("a.pgw", "1.5\r\n-5.0\r\n-5.0\r\n-1.5\r\n600000\r\n5200000\r\n");
  OpenOptions options;
  options.image_heights_m = {0.0, 1000.0};
  const auto raster = open(path, options);
  EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(600000.0, 5200000.0));
  EXPECT_EQ(centre_of(*raster, 1, 1), dvec2(600000.0 + 1.5 - 5.0, 5200000.0 - 5.0 - 1.5));
  EXPECT_TRUE(has_note(*raster, "/terrain/crs"));
  folder.write("a.prj", "PROJCS[\"x\"]");
  EXPECT_EQ(open(path, options)->info().georeference->crs, "PROJCS[\"x\"]");
  folder.write("a.pgw", "1 2 2 4 0 0");
  EXPECT_TRUE(says(refusal_of([&] { open(path, options); }), "without an area"));
}

TEST(Png, TilesAreGuessedAndSaid) {
  for (const TileEncoding& encoding : {kTerrarium, kTerrainRgb}) {
    for (const int channels : {3, 4}) {
      const Folder folder;
      std::vector<int> values = hill(encoding, channels);
      const auto path =
          folder.write("11/385/803.png", png(256, 256, 8, channels == 3 ? 2 : 6, values));
      const auto raster = open(path);
      EXPECT_NEAR(height_at(*raster, 0, 0), 1500.0, encoding.step_m) << encoding.name;
      EXPECT_NEAR(height_at(*raster, 80, 0), 1500.0 + 900.0 * std::sin(1.6), encoding.step_m);
      EXPECT_TRUE(has_note(*raster, std::string("in the encoding ") + encoding.name));
      EXPECT_TRUE(has_note(*raster, "tile 11/385/803"));
    }
  }
}

TEST(Png, APictureIsNotTakenForHeights) {
  std::vector<int> values;
  for (int i = 0; i < 64 * 64; ++i) values.insert(values.end(), {i * 7 % 256, i * 13 % 256, 99});
  const Folder folder;
  const auto path = folder.write("9_3_4.png", png(64, 64, 8, 2, values));
  EXPECT_TRUE(says(refusal_of([&] { open(path); }), "/terrain/encoding"));
  const auto jpeg = folder.write("9_3_4.jpg", "\xff\xd8\xff\xe0 and so on");
  EXPECT_TRUE(says(refusal_of([&] { open(jpeg); }), "compression damages heights"));
}

TEST(Png, BlackAndTransparentPixelsOfTilesAreVoids) {
  const Folder folder;
  std::vector<int> values = hill(kTerrainRgb, 4);
  for (std::size_t i = 0; i < 3; ++i) values[i] = 0;
  values[7] = 0;
  const auto raster = open(folder.write("1_0_0.png", png(256, 256, 8, 6, values)));
  EXPECT_TRUE(std::isnan(height_at(*raster, 0, 0)));
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 0)));
  EXPECT_FALSE(std::isnan(height_at(*raster, 2, 0)));
}

TEST(Png, BaseAndStepOfATileMayBeSaid) {
  const Folder folder;
  OpenOptions options = said(-100.0, -100.0 + 0.001 * 16777215.0, 10.0);
  options.encoding = "terrain-rgb";
  const auto path = folder.write("a.png", png(2, 2, 8, 2, {0, 0, 1, 1, 0, 0, 0, 1, 0, 2, 0, 0}));
  const auto raster = open(path, options);
  EXPECT_NEAR(height_at(*raster, 0, 0), -99.999, 1e-4);
  EXPECT_NEAR(height_at(*raster, 1, 0), -100.0 + 65.536, 1e-4);
  options.encoding = "other";
  EXPECT_TRUE(says(refusal_of([&] { open(path, options); }), "the encoding \"other\" is unknown"));
}

TEST(Png, ThePlaceOfATileIsInItsName) {
  struct Case {
    const char* path;
    int z, x, y;
  };
  for (const Case& c :
       {Case{"terrarium_11_385_803.png", 11, 385, 803}, Case{"11/385/803.png", 11, 385, 803},
        Case{"a/b/11/385/803@2x.png", 11, 385, 803}, Case{"0/0/0.png", 0, 0, 0},
        Case{"11-385-803.png", 11, 385, 803}}) {
    const auto tile = tile_number_of(c.path);
    ASSERT_TRUE(tile) << c.path;
    EXPECT_EQ(tile->z, c.z);
    EXPECT_EQ(tile->x, c.x);
    EXPECT_EQ(tile->y, c.y);
  }
  for (const char* path : {"davos.png", "2_4_1.png", "2/1/-1.png", "99_1_1.png", "385_803.png",
                           "a/385/803.png", "1_x_1.png", "99999999999_1_1.png", "_1_1.png"}) {
    EXPECT_FALSE(tile_number_of(path)) << path;
  }
  const Georeference place = place_of_tile({1, 1, 0}, 256);
  const double half = 20037508.342789244, pixel = half / 256.0;
  EXPECT_EQ(place.crs, "EPSG:3857");
  EXPECT_NEAR(place.origin.x, 0.5 * pixel, 1e-6);
  EXPECT_NEAR(place.origin.y, half - 0.5 * pixel, 1e-6);
  EXPECT_NEAR(place.per_row.y, -pixel, 1e-9);
}

TEST(Png, ATileWithoutAPlaceIsRefused) {
  const Folder folder;
  const auto renamed = folder.write("tile.png", png(256, 256, 8, 2, hill(kTerrarium, 3)));
  EXPECT_TRUE(says(refusal_of([&] { open(renamed); }), "/terrain/cell_m"));
  const auto odd = folder.write("3_1_1.png", png(200, 200, 8, 2, hill(kTerrarium, 3, 200)));
  EXPECT_TRUE(says(refusal_of([&] { open(odd); }), "256 or 512 pixels"));
  OpenOptions options;
  options.cell_m = 12.0;
  EXPECT_EQ(open(odd, options)->info().georeference->per_column.x, 12.0);
}

TEST(Png, DamagedFilesAreRefused) {
  const Folder folder;
  const std::string good = png(2, 2, 16, 0, {0, 65535, 256, 1});
  const auto refused = [&](const std::string& bytes) {
    return refusal_of([&] { open(folder.write("a.png", bytes), said(0.0, 1.0, 1.0)); });
  };
  EXPECT_TRUE(says(refused(good.substr(0, good.size() - 13)), "cut short"));
  std::string bad = good;
  bad[60] = static_cast<char>(bad[60] ^ 1);
  EXPECT_TRUE(says(refused(bad), "checksum"));
  EXPECT_TRUE(says(refused(png(100000, 60000, 16, 0, {0, 0})), "at most 268435456"));
  EXPECT_TRUE(says(refused(png(10000, 10000, 16, 0, {0, 0, 0, 0})), "too few for 10000 x 10000"));
  EXPECT_TRUE(says(refused(png(3, 3, 16, 0, {0, 0, 0, 0})), "cannot be decoded"));
}

}  // namespace
}  // namespace aerostat::elevation
