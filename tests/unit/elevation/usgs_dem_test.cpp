// The traps of USGS DEM: Fortran numbers without spaces between them, ragged rims, units, datums.

#include "elevation/usgs_dem.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "files.hpp"

namespace aerostat::elevation {
namespace {

/// Returns a number of 24 letters, as Fortran writes it.
std::string fortran(double value) {
  std::string text = fmt::format("{:24.15E}", value);
  text[text.find('E')] = 'D';
  return text;
}

struct Column {
  double x, y;
  std::vector<int> heights;
};

/// A small USGS DEM.
struct File {
  int system = 1, zone = 10, ground_unit = 2, height_unit = 2;
  double dx = 30.0, dy = 30.0, dz = 1.0, datum_height = 0.0;
  std::size_t record_a = 1024;
  std::string datums = "    ";
  std::vector<Column> columns{{500000.0, 4000000.0, {1, 2, 3}},
                              {500030.0, 4000030.0, {-32767, -430}}};

  std::string bytes() const {
    std::string a(record_a, ' ');
    const auto put = [&](std::size_t at, const std::string& text) {
      a.replace(at, text.size(), text);
    };
    put(0, "A TEST");
    put(144, fmt::format("{:6}{:6}{:6}{:6}", 1, 1, system, zone));
    put(528, fmt::format("{:6}{:6}{:6}", ground_unit, height_unit, 4));
    put(816, fmt::format("{:12.6E}{:12.6E}{:12.6E}{:6}{:6}", dx, dy, dz, 1, columns.size()));
    if (record_a > 900) put(888, datums);
    std::string file = a;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Column& column = columns[i];
      std::string b = fmt::format("{:6}{:6}{:6}{:6}", 1, i + 1, column.heights.size(), 1) +
                      fortran(column.x) + fortran(column.y) + fortran(datum_height) + fortran(0.0) +
                      fortran(0.0);
      std::size_t left = 146;
      for (const int height : column.heights) {
        if (left-- == 0) {
          b.resize((b.size() + 1023) / 1024 * 1024, ' ');
          left = 169;
        }
        b += fmt::format("{:6}", height);
      }
      b.resize((b.size() + 1023) / 1024 * 1024, ' ');
      file += b;
    }
    return file;
  }
};

std::unique_ptr<Raster> opened(const File& file, const OpenOptions& options = {}) {
  const Folder folder;
  return open(folder.write("a.dem", file.bytes()), options);
}

TEST(UsgsDem, ColumnsRunFromTheWestAndRaggedRimsAreVoid) {
  const auto raster = opened({});
  EXPECT_EQ(raster->info().width, 2);
  EXPECT_EQ(raster->info().height, 3);
  EXPECT_EQ(height_at(*raster, 0, 0), 3.0f);
  EXPECT_EQ(height_at(*raster, 0, 2), 1.0f);
  EXPECT_EQ(height_at(*raster, 1, 0), -430.0f);
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 1)));
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 2)));
  EXPECT_EQ(centre_of(*raster, 0, 2), dvec2(500000.0, 4000000.0));
  EXPECT_EQ(centre_of(*raster, 1, 0), dvec2(500030.0, 4000060.0));
}

TEST(UsgsDem, WithoutADatumItIsNad27AndThatIsSaid) {
  const auto raster = opened({});
  EXPECT_EQ(raster->info().georeference->crs, "EPSG:26710");
  EXPECT_TRUE(has_note(*raster, "NAD27 was taken"));
}

TEST(UsgsDem, SystemsDatumsAndZones) {
  struct Case {
    int system, zone;
    const char* datums;
    const char* crs;
    const char* vertical;
  };
  for (const Case& c :
       {Case{1, 10, " 2 1", "EPSG:26710", "NGVD29"}, Case{1, 13, " 3 4", "EPSG:26913", "NAVD88"},
        Case{1, -19, " 1 3", "EPSG:32719", "mean sea level"}, Case{1, 33, " 0 2", "EPSG:32233", ""},
        Case{0, 0, " 1 7", "EPSG:4269", "mean sea level"}, Case{2, 401, " 2 1", "", "NGVD29"},
        Case{1, 4, " 2 5", "", "NGVD29"}}) {
    File file;
    file.system = c.system;
    file.zone = c.zone;
    file.datums = c.datums;
    if (c.system == 0) {
      file.ground_unit = 3;
      file.columns = {{36000.0, 162000.0, {1, 2}}, {36030.0, 162000.0, {1, 2}}};
    }
    const auto raster = opened(file);
    EXPECT_EQ(raster->info().georeference->crs, c.crs) << c.datums;
    EXPECT_EQ(raster->info().vertical_datum, c.vertical) << c.datums;
    EXPECT_EQ(has_note(*raster, "/terrain/crs"), std::string(c.crs).empty()) << c.datums;
  }
}

TEST(UsgsDem, SecondsOfArcBecomeDegrees) {
  File file;
  file.system = 0;
  file.ground_unit = 3;
  file.dx = file.dy = 3.0;
  file.columns = {{-259200.0, 158400.0, {1, 2}}, {-259197.0, 158400.0, {3, 4}}};
  const auto raster = opened(file);
  EXPECT_EQ(raster->info().georeference->crs, "EPSG:4267");
  EXPECT_NEAR(centre_of(*raster, 0, 1).x, -72.0, 1e-12);
  EXPECT_NEAR(centre_of(*raster, 0, 1).y, 44.0, 1e-12);
  EXPECT_NEAR(raster->info().georeference->per_column.x, 1.0 / 1200.0, 1e-15);
}

TEST(UsgsDem, FeetStepsAndLocalDatumsCount) {
  File file;
  file.height_unit = 1;
  file.dz = 0.1;
  file.datum_height = 100.0;
  const auto raster = opened(file);
  EXPECT_EQ(raster->info().unit, "foot");
  EXPECT_FLOAT_EQ(height_at(*raster, 0, 0), (100.0f + 0.3f) * 0.3048f);
  OpenOptions options;
  options.metres_per_unit = 1.0;
  options.crs = "EPSG:26910";
  const auto said = opened(file, options);
  EXPECT_FLOAT_EQ(height_at(*said, 0, 0), 100.3f);
  EXPECT_EQ(said->info().georeference->crs, "EPSG:26910");
}

TEST(UsgsDem, LongColumnsGoOnInFurtherBlocksAndNumbersMayTouch) {
  File file;
  std::vector<int> heights;
  for (int j = 0; j < 700; ++j) heights.push_back(j % 3 == 0 ? 100000 + j : -32767 + j);
  file.columns = {{500000.0, 4000000.0, heights}, {500030.0, 4000000.0, heights}};
  const auto raster = opened(file);
  ASSERT_EQ(raster->info().height, 700);
  for (int j = 0; j < 700; ++j) {
    const int stored = heights[static_cast<std::size_t>(j)];
    const float height = height_at(*raster, 1, 699 - j);
    if (stored == -32767) {
      ASSERT_TRUE(std::isnan(height)) << j;
    } else {
      ASSERT_EQ(height, static_cast<float>(stored)) << j;
    }
  }
}

TEST(UsgsDem, EndsOfLinesAndShortenedBlocksDoNotHarm) {
  const std::string good = File{}.bytes();
  const Folder folder;
  std::string lines, shortened = good.substr(0, 1024);
  for (std::size_t at = 0; at < good.size(); at += 1024) {
    lines += good.substr(at, 1024) + "\r\n";
    if (at == 0) continue;
    const std::string block = good.substr(at, 1024);
    shortened += "\n" + block.substr(0, block.find_last_not_of(' ') + 1);
  }
  for (const std::string& text : {lines, shortened}) {
    const auto raster = open(folder.write("a.dem", text));
    EXPECT_EQ(height_at(*raster, 0, 0), 3.0f);
    EXPECT_EQ(height_at(*raster, 1, 0), -430.0f);
  }
}

TEST(UsgsDem, OlderEditionsHaveAShorterHeader) {
  File file;
  file.record_a = 864;
  EXPECT_EQ(height_at(*opened(file), 0, 0), 3.0f);
}

TEST(UsgsDem, WhatCannotBeReadSaysWhy) {
  const Folder folder;
  const auto refused = [&](const std::string& bytes) {
    return refusal_of([&] { open(folder.write("a.dem", bytes)); });
  };
  const std::string good = File{}.bytes();
  EXPECT_TRUE(says(refused(good.substr(0, 1024)), "no record B"));
  EXPECT_TRUE(says(refused(good.substr(0, 2048)), "no part of a number"));
  File file;
  file.dz = 0.0;
  EXPECT_TRUE(says(refused(file.bytes()), "a resolution above 0 is expected"));
  file = {};
  file.columns[1].x = 9e9;
  EXPECT_TRUE(says(refused(file.bytes()), "only 5 heights are given"));
  file = {};
  file.ground_unit = 0;
  EXPECT_TRUE(says(refused(file.bytes()), "in radians"));
}

}  // namespace
}  // namespace aerostat::elevation
