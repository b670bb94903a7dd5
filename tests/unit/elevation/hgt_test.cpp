// The traps of SRTM tiles: place, size, byte order, voids and packing.

#include "elevation/hgt.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "files.hpp"
#include "packed.hpp"

namespace aerostat::elevation {
namespace {

/// Returns a tile with the same height everywhere, apart from the corners in the north-west (1),
/// north-east (2), south-west (3) and south-east (4).
std::string tile(int width, int height) {
  const std::size_t samples = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::string bytes;
  for (std::size_t i = 0; i < samples; ++i) bytes += {'\x01', '\x02'};  // 258 m
  const auto set = [&](std::size_t i, std::string_view two) { bytes.replace(2 * i, 2, two); };
  set(0, {"\x00\x01", 2});
  set(static_cast<std::size_t>(width) - 1, {"\x00\x02", 2});
  set(samples - static_cast<std::size_t>(width), {"\x00\x03", 2});
  set(samples - 1, {"\x00\x04", 2});
  set(1, {"\x80\x00", 2});  // a void
  set(2, {"\xFE\x52", 2});  // -430 m, the shore of the Dead Sea
  set(3, {"\x80\x01", 2});  // -32767 is no mark in this format
  return bytes;
}

TEST(Hgt, RowsRunFromTheNorthAndNumbersAreBigEndian) {
  const Folder folder;
  const auto raster = open(folder.write("N46E009.hgt", tile(1201, 1201)));
  EXPECT_EQ(raster->info().width, 1201);
  EXPECT_EQ(raster->info().height, 1201);
  EXPECT_EQ(height_at(*raster, 0, 0), 1.0f);
  EXPECT_EQ(height_at(*raster, 1200, 0), 2.0f);
  EXPECT_EQ(height_at(*raster, 0, 1200), 3.0f);
  EXPECT_EQ(height_at(*raster, 1200, 1200), 4.0f);
  EXPECT_EQ(height_at(*raster, 600, 600), 258.0f);
  EXPECT_EQ(raster->info().georeference->crs, "EPSG:4326");
  EXPECT_EQ(raster->info().sample_type, "int16");
}

TEST(Hgt, VoidsAreMinus32768AndNegativeHeightsAreData) {
  const Folder folder;
  const auto raster = open(folder.write("N31E035.hgt", tile(1201, 1201)));
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 0)));
  EXPECT_EQ(height_at(*raster, 2, 0), -430.0f);
  EXPECT_EQ(height_at(*raster, 3, 0), -32767.0f);
}

TEST(Hgt, TheNameGivesTheCentreOfTheCornerInTheSouthWest) {
  struct Case {
    const char* name;
    double west, north;
  };
  const std::string bytes = tile(1201, 1201);
  for (const Case& c : {Case{"N46E009.hgt", 9, 47}, Case{"n44w072.HGT", -72, 45},
                        Case{"S14W067.hgt", -67, -13}, Case{"s01e000.hgt", 0, 0},
                        Case{"N00E010.SRTMGL3.hgt", 10, 1}, Case{"dem_N60E179.hgt", 179, 61}}) {
    const Folder folder;
    const auto raster = open(folder.write(c.name, bytes));
    EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(c.west, c.north)) << c.name;
    EXPECT_NEAR(centre_of(*raster, 1200, 1200).x, c.west + 1.0, 1e-12) << c.name;
    EXPECT_NEAR(centre_of(*raster, 1200, 1200).y, c.north - 1.0, 1e-12) << c.name;
  }
}

TEST(Hgt, ARenamedFileIsRefusedUnlessACellIsGiven) {
  const Folder folder;
  const auto path = folder.write("davos.hgt", tile(1201, 1201));
  const std::string said = refusal_of([&] { open(path); });
  EXPECT_TRUE(says(said, "davos.hgt: the name davos.hgt does not give the place"));
  EXPECT_TRUE(says(said, "/terrain/cell_m"));
  OpenOptions options;
  options.cell_m = 30.0;
  const auto raster = open(path, options);
  EXPECT_EQ(raster->info().georeference->per_column, dvec2(30.0, 0.0));
  EXPECT_TRUE(has_note(*raster, "does not give the place"));
  for (const char* name :
       {"N46E09.hgt", "N91E000.hgt", "N46E181.hgt", "N46E0090.hgt", "XN46E009.hgt"}) {
    EXPECT_FALSE(corner_of_name(name)) << name;
  }
}

TEST(Hgt, TheSideFollowsFromTheSizeOfTheFile) {
  struct Case {
    int width, height;
  };
  for (const Case& c : {Case{3601, 3601}, Case{1801, 3601}, Case{7201, 7201}}) {
    const Folder folder;
    const auto raster = open(folder.write("N60E010.hgt", tile(c.width, c.height)));
    EXPECT_EQ(raster->info().width, c.width);
    EXPECT_EQ(raster->info().height, c.height);
    EXPECT_EQ(height_at(*raster, c.width - 1, c.height - 1), 4.0f);
    EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(10.0, 61.0));
    EXPECT_NEAR(centre_of(*raster, c.width - 1, 0).x, 11.0, 1e-12);
  }
  const Folder folder;
  const auto path = folder.write("N60E010.hgt", tile(1200, 1200));
  EXPECT_TRUE(
      says(refusal_of([&] { open(path); }), "2880000 bytes was found; 2884802 (1201 x 1201"));
  EXPECT_TRUE(
      says(refusal_of([&] { open(folder.write("N60E011.hgt", "")); }), "of 0 bytes was found"));
}

TEST(Hgt, ZippedAndGzippedTilesAreReadAsFound) {
  const std::string bytes = tile(1201, 1201);
  const Folder folder;
  for (const auto& path :
       {folder.write("N48W125.hgt.zip", zip({{"N48W125.hgt", bytes}})),
        folder.write("renamed.zip", zip({{"readme.txt", "text"}, {"data/N48W125.HGT", bytes}})),
        folder.write("mac.zip", zip({{"__MACOSX/._N48W125.hgt", "x"}, {"N48W125.hgt", bytes}})),
        folder.write("N48W125.zip", zip({{"tile.hgt", bytes}})),
        folder.write("stored.zip", zip({{"N48W125.hgt", bytes}}, 0)),
        folder.write("N48W125.hgt.gz", gzip(bytes))}) {
    const auto raster = open(path);
    EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(-125.0, 49.0)) << path;
    EXPECT_EQ(height_at(*raster, 1200, 1200), 4.0f) << path;
    EXPECT_TRUE(std::isnan(height_at(*raster, 1, 0))) << path;
  }
}

TEST(Hgt, AZipFileThatCannotBeUsedSaysWhy) {
  const Folder folder;
  const std::string bytes = tile(1201, 1201);
  const std::string good = zip({{"N48W125.hgt", bytes}});
  const auto refused = [&](const std::string& content) {
    return refusal_of([&] { open(folder.write("a.zip", content)); });
  };
  EXPECT_TRUE(
      says(refused(zip({{"a.txt", "text"}})), "1 members, and none of them is a .hgt file"));
  EXPECT_TRUE(
      says(refused(zip({{"N48W125.hgt", bytes}, {"N48W124.hgt", bytes}})), "more than one .hgt"));
  EXPECT_TRUE(says(refused(zip({{"N48W125.hgt", bytes}}, 8, 1)), "encrypted"));
  EXPECT_TRUE(says(refused(zip({{"N48W125.hgt", bytes}}, 12)), "packed by method 12"));
  EXPECT_TRUE(says(refused(good.substr(0, good.size() / 2)), "its directory is missing"));
  std::string damaged = good;
  damaged[200] = static_cast<char>(damaged[200] ^ 0x55);
  EXPECT_TRUE(says(refused(damaged), "N48W125.hgt in it is damaged"));
  std::string stored = zip({{"N48W125.hgt", bytes}}, 0);
  stored[200] = static_cast<char>(stored[200] ^ 0x55);
  EXPECT_TRUE(says(refused(stored), "N48W125.hgt in it is damaged"));
  std::string large = good;
  large.replace(large.size() - 6, 4, "\xff\xff\xff\xff");
  EXPECT_TRUE(says(refused(large), "zip64"));
  EXPECT_TRUE(says(refused(zip({{"N48W125.hgt", "short"}})), "of 5 bytes was found"));
  const std::string bomb(std::size_t{2} * 7201 * 7201 + 1, '\0');
  EXPECT_TRUE(says(refused(zip({{"N48W125.hgt", bomb}})), "at most 103708802"));
  EXPECT_TRUE(says(refusal_of([&] { open(folder.write("N48W125.hgt.gz", gzip(bomb))); }),
                   "more than 103708802 bytes"));
}

TEST(Hgt, WhatTheUserSaysWins) {
  const Folder folder;
  OpenOptions options;
  options.crs = "EPSG:4269";
  options.metres_per_unit = 0.3048;
  options.nodata = 258.0;
  const auto raster = open(folder.write("N46E009.hgt", tile(1201, 1201)), options);
  EXPECT_EQ(raster->info().georeference->crs, "EPSG:4269");
  EXPECT_EQ(raster->info().unit, "foot");
  EXPECT_FLOAT_EQ(height_at(*raster, 2, 0), -430.0f * 0.3048f);
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 0)));
  EXPECT_TRUE(std::isnan(height_at(*raster, 600, 600)));
}

TEST(Hgt, AWindowIsReadAsItLiesInTheFile) {
  const Folder folder;
  const auto raster = open(folder.write("N46E009.hgt", tile(1201, 1201)));
  std::array<float, 4> heights{};
  raster->read({1199, 1199, 2, 2}, heights.data());
  EXPECT_EQ(heights, (std::array<float, 4>{258.0f, 258.0f, 258.0f, 4.0f}));
}

}  // namespace
}  // namespace aerostat::elevation
