// The traps of DTED: signs, columns from the west and the south, checksums, levels.

#include "elevation/dted.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "files.hpp"

namespace aerostat::elevation {
namespace {

/// A DTED file of a few columns.
struct File {
  std::string west = "0100000E", south = "0460000N";
  int column_seconds_tenths = 30, row_seconds_tenths = 30;
  std::string vertical = "MSL", datum = "WGS84";
  std::string labels;
  std::vector<std::vector<int>> columns{{1, 2, 3}, {4, 5, 6}};  // from the south, as bits
  bool wrong_sum = false;

  std::string bytes() const {
    std::string uhl = "UHL1" + west + south +
                      fmt::format("{:04}{:04}", column_seconds_tenths, row_seconds_tenths) +
                      "NA  U  " + std::string(12, ' ') +
                      fmt::format("{:04}{:04}0", columns.size(), columns[0].size());
    uhl.resize(80, ' ');
    std::string dsi(648, ' ');
    dsi.replace(0, 3, "DSI");
    dsi.replace(141, 3, vertical);
    dsi.replace(144, 5, datum);
    std::string file = labels + uhl + dsi + std::string(2700, ' ');
    for (std::size_t i = 0; i < columns.size(); ++i) {
      std::string record = {'\xAA', 0, 0, static_cast<char>(i), 0, static_cast<char>(i), 0, 0};
      for (const int bits : columns[i]) {
        record += static_cast<char>(bits >> 8 & 255);
        record += static_cast<char>(bits & 255);
      }
      std::uint32_t sum = wrong_sum ? 1 : 0;
      for (const char c : record) sum += static_cast<std::uint8_t>(c);
      for (int shift = 24; shift >= 0; shift -= 8) record += static_cast<char>(sum >> shift & 255);
      file += record;
    }
    return file;
  }
};

std::unique_ptr<Raster> opened(const File& file) {
  const Folder folder;
  return open(folder.write("a.dt1", file.bytes()));
}

TEST(Dted, ColumnsRunFromTheWestAndRowsFromTheSouth) {
  const auto raster = opened({});
  EXPECT_EQ(raster->info().width, 2);
  EXPECT_EQ(raster->info().height, 3);
  EXPECT_EQ(heights_of(*raster), (std::vector<float>{3, 6, 2, 5, 1, 4}));
  EXPECT_EQ(raster->info().georeference->crs, "EPSG:4326");
  EXPECT_EQ(raster->info().vertical_datum, "mean sea level");
  EXPECT_NEAR(centre_of(*raster, 0, 2).x, 10.0, 1e-12);
  EXPECT_NEAR(centre_of(*raster, 0, 2).y, 46.0, 1e-12);
  EXPECT_NEAR(centre_of(*raster, 1, 0).x, 10.0 + 3.0 / 3600.0, 1e-12);
  EXPECT_NEAR(centre_of(*raster, 1, 0).y, 46.0 + 6.0 / 3600.0, 1e-12);
}

TEST(Dted, ASignBitMakesNegativeHeights) {
  File file;
  file.columns = {{0x8000, 0x81AE, 0xFFFF}, {0x80FF, 0x0000, 0x7FFF}};
  const auto raster = opened(file);
  EXPECT_EQ(height_at(*raster, 0, 2), 0.0f);
  EXPECT_EQ(height_at(*raster, 0, 1), -430.0f);
  EXPECT_TRUE(std::isnan(height_at(*raster, 0, 0)));
  EXPECT_EQ(height_at(*raster, 1, 2), -255.0f);
  EXPECT_EQ(height_at(*raster, 1, 0), 32767.0f);
  EXPECT_TRUE(raster->info().notes.empty());
}

TEST(Dted, ComplementsAgainstTheRulesAreReadAndSaid) {
  File file;
  file.columns = {{0xFFFE, 0xFE52, 1}, {2, 3, 4}};
  const auto raster = opened(file);
  EXPECT_EQ(height_at(*raster, 0, 2), -2.0f);
  EXPECT_EQ(height_at(*raster, 0, 1), -430.0f);
  EXPECT_TRUE(has_note(*raster, "2 heights below -16000 m"));
}

TEST(Dted, AWrongChecksumIsSaid) {
  File file;
  file.wrong_sum = true;
  const auto raster = opened(file);
  EXPECT_EQ(height_at(*raster, 0, 2), 1.0f);
  EXPECT_TRUE(has_note(*raster, "The checksum of 2 of 2 columns is wrong"));
}

TEST(Dted, LongitudesMayBeWesternAndCellsWiderTowardsThePoles) {
  File file;
  file.west = "0701530W";
  file.south = "0500000S";
  file.column_seconds_tenths = 20;
  file.row_seconds_tenths = 10;
  const auto raster = opened(file);
  EXPECT_NEAR(centre_of(*raster, 0, 2).x, -(70.0 + 15.0 / 60.0 + 30.0 / 3600.0), 1e-12);
  EXPECT_NEAR(centre_of(*raster, 0, 2).y, -50.0, 1e-12);
  EXPECT_NEAR(raster->info().georeference->per_column.x, 2.0 / 3600.0, 1e-15);
  EXPECT_NEAR(raster->info().georeference->per_row.y, -1.0 / 3600.0, 1e-15);
}

TEST(Dted, LabelsOfTapesMayStandInFront) {
  File file;
  file.labels = std::string("VOL1") + std::string(76, ' ') + "HDR1" + std::string(76, ' ');
  EXPECT_EQ(height_at(*opened(file), 0, 2), 1.0f);
}

TEST(Dted, TheDatumIsReadOrSaid) {
  File file;
  file.datum = "WGS72";
  file.vertical = "E96";
  const auto old = opened(file);
  EXPECT_EQ(old->info().georeference->crs, "EPSG:4322");
  EXPECT_EQ(old->info().vertical_datum, "EGM96 height");
  file.datum = "     ";
  EXPECT_TRUE(has_note(*opened(file), "WGS 84 was taken"));
}

TEST(Dted, WhatCannotBeReadSaysWhy) {
  const Folder folder;
  const std::string good = File{}.bytes();
  const auto refused = [&](const std::string& bytes) {
    return refusal_of([&] { open(folder.write("a.dt2", bytes)); });
  };
  EXPECT_TRUE(says(refused(good.substr(0, 100)), "its header alone has 3428"));
  EXPECT_TRUE(says(refused(good.substr(0, good.size() - 1)), "2 x 3 heights need 3464"));
  std::string bad = good;
  bad[3428] = 1;
  EXPECT_TRUE(says(refused(bad), "column 1 of the DTED file begins with byte 1; 170"));
  bad = good;
  bad.replace(4, 8, "01000xxE");
  EXPECT_TRUE(says(refused(bad), "digits are expected"));
  bad = good;
  bad[11] = 'Q';
  EXPECT_TRUE(says(refused(bad), "an angle such as 0460000N"));
  bad = good;
  bad.replace(20, 4, "0000");
  EXPECT_TRUE(says(refused(bad), "0 seconds of arc"));
}

}  // namespace
}  // namespace aerostat::elevation
