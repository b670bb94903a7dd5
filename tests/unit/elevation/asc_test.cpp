// The traps of ESRI's text grids, one after the other.

#include "elevation/asc.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "files.hpp"

namespace aerostat::elevation {
namespace {

const std::string kBody = "1 2 3\n4 5 6\n";

std::unique_ptr<Raster> opened(const std::string& text, const OpenOptions& options = {}) {
  const Folder folder;
  return open(folder.write("a.asc", text), options);
}

std::string refused(const std::string& text) {
  return refusal_of([&] { opened(text); });
}

std::string header(const std::string& rest = "xllcorner 100\nyllcorner 200\ncellsize 10\n") {
  return "ncols 3\nnrows 2\n" + rest;
}

TEST(Asc, RowsRunFromTheNorthAndACornerIsHalfACellOff) {
  const auto raster = opened(header() + kBody);
  EXPECT_EQ(heights_of(*raster), (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(105.0, 215.0));
  EXPECT_EQ(centre_of(*raster, 2, 1), dvec2(125.0, 205.0));
}

TEST(Asc, ACentreIsTheFirstSampleItself) {
  const auto raster = opened(header("xllcenter 100\nyllcenter 200\ncellsize 10\n") + kBody);
  EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(100.0, 210.0));
  const auto mixed = opened(header("xllcorner 100\nyllcenter 200\ncellsize 10\n") + kBody);
  EXPECT_EQ(centre_of(*mixed, 0, 1), dvec2(105.0, 200.0));
}

TEST(Asc, TheHeaderMayHaveAnyOrderCaseAndLineEnds) {
  const auto raster = opened(
      "\xEF\xBB\xBFNODATA_VALUE 4\r\nCellSize 10\r\nYLLCORNER 200\r\nxllCorner 1e2\r\nNROWS 2\r\n"
      "NCOLS 3\r\n1 2\r\n3 4 5 6\r\n\x1a");
  EXPECT_EQ(raster->info().width, 3);
  EXPECT_EQ(centre_of(*raster, 0, 0), dvec2(105.0, 215.0));
  EXPECT_EQ(height_at(*raster, 2, 0), 3.0f);
  EXPECT_TRUE(std::isnan(height_at(*raster, 0, 1)));
}

TEST(Asc, CellsMayBeLongerThanWide) {
  const auto raster = opened(header("xllcorner 0\nyllcorner 0\ndx 21\ndy 31\n") + kBody);
  EXPECT_EQ(raster->info().georeference->per_column, dvec2(21.0, 0.0));
  EXPECT_EQ(raster->info().georeference->per_row, dvec2(0.0, -31.0));
  EXPECT_EQ(centre_of(*raster, 0, 1), dvec2(10.5, 15.5));
}

TEST(Asc, WithoutNodataTheValueOfEsriIsAVoid) {
  const auto raster = opened(header() + "1 -9999 3\n4 5 -9999.0\n");
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 0)));
  EXPECT_TRUE(std::isnan(height_at(*raster, 2, 1)));
  EXPECT_TRUE(has_note(*raster, "-9999"));
  const auto named = opened(header() + "nodata_value -1\n1 -9999 3\n-1 5 6\n");
  EXPECT_EQ(height_at(*named, 1, 0), -9999.0f);
  EXPECT_TRUE(std::isnan(height_at(*named, 0, 1)));
}

TEST(Asc, WordsForMissingHeightsAreVoids) {
  const auto raster = opened(header() + "NODATA_value -9999\nnan null -nan\n1.#QNAN inf 6\n");
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(std::isnan(height_at(*raster, i % 3, i / 3))) << i;
  EXPECT_EQ(height_at(*raster, 2, 1), 6.0f);
  const auto tagged = opened(header() + "NODATA_value nan\nnan 2 3\n4 5 6\n");
  EXPECT_TRUE(std::isnan(height_at(*tagged, 0, 0)));
}

TEST(Asc, TheTextOfTheLowestFloatIsAVoid) {
  const auto raster = opened(header() +
                             "NODATA_value -3.40282e+38\n-3.4028235e+38 2 3\n"
                             "-3.40282346638529e+038 -3.4e38 6\n");
  EXPECT_TRUE(std::isnan(height_at(*raster, 0, 0)));
  EXPECT_TRUE(std::isnan(height_at(*raster, 0, 1)));
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 1)));
}

TEST(Asc, NegativeHeightsAndAnyFormOfNumbersAreData) {
  const auto raster = opened(header() + "-430.25 +2 3.\n.5 1.5E+03 123456789.123456789\n");
  EXPECT_EQ(heights_of(*raster),
            (std::vector<float>{-430.25f, 2.0f, 3.0f, 0.5f, 1500.0f, 123456789.123456789f}));
  EXPECT_EQ(raster->info().sample_type, "float32");
  EXPECT_EQ(opened(header() + kBody)->info().sample_type, "int32");
}

TEST(Asc, ADecimalCommaIsReadAndSaid) {
  const auto raster = opened(header("xllcorner 100,5\nyllcorner 200\ncellsize 10,0\n") +
                             "1,5 2 3\n4 5 1234567,25\n");
  EXPECT_EQ(centre_of(*raster, 0, 1), dvec2(105.5, 205.0));
  EXPECT_EQ(height_at(*raster, 0, 0), 1.5f);
  EXPECT_EQ(height_at(*raster, 2, 1), 1234567.25f);
  EXPECT_TRUE(has_note(*raster, "Commas"));
  EXPECT_TRUE(says(refused(header() + "1,2,3\n4,5,6\n"), "row 1, column 1 has \"1,2,3\""));
}

TEST(Asc, AMissingSystemIsSaidAndAPrjBesideGivesIt) {
  EXPECT_TRUE(has_note(*opened(header() + kBody), "/terrain/crs"));
  const Folder folder;
  const auto path = folder.write("b.asc", header() + kBody);
  const std::string wkt = "PROJCS[\"MGI_Austria_Lambert\",GEOGCS[\"GCS_MGI\"]]";
  folder.write("b.prj", wkt);
  EXPECT_EQ(open(path)->info().georeference->crs, wkt);
  EXPECT_TRUE(open(path)->info().notes.empty());
  OpenOptions options;
  options.crs = "EPSG:31287";
  EXPECT_EQ(open(path, options)->info().georeference->crs, "EPSG:31287");
  folder.write("b.prj", "Projection    UTM\nDatum NAD27\nZone  10\nUnits METERS\nParameters\n");
  EXPECT_EQ(open(path)->info().georeference->crs, "EPSG:26710");
  folder.write("b.prj", "Projection GEOGRAPHIC\nDatum WGS84\nUnits DD\n");
  EXPECT_TRUE(says(refusal_of([&] { open(path); }), "look like metres"));
  folder.write("b.asc", header("xllcorner 9\nyllcorner 47\ncellsize 0.001\n") + kBody);
  EXPECT_EQ(open(path)->info().georeference->crs, "EPSG:4326");
  folder.write("b.prj", "hello");
  EXPECT_TRUE(has_note(*open(path), "left aside"));
  folder.write("b.prj", wkt + std::string(70000, ' '));
  EXPECT_TRUE(open(path)->info().georeference->crs.empty());
}

TEST(Asc, UnitAndMarkOfTheUserWin) {
  OpenOptions options;
  options.metres_per_unit = 0.3048;
  options.nodata = 2.0;
  const auto raster = opened(header() + "nodata_value 6\n" + kBody, options);
  EXPECT_FLOAT_EQ(height_at(*raster, 0, 0), 0.3048f);
  EXPECT_TRUE(std::isnan(height_at(*raster, 1, 0)));
  EXPECT_FLOAT_EQ(height_at(*raster, 2, 1), 6.0f * 0.3048f);
  EXPECT_EQ(raster->info().unit, "foot");
}

TEST(Asc, WhatCannotBeReadSaysWhere) {
  EXPECT_TRUE(says(refused(header() + "1 2 3\n4 5\n"),
                   "a.asc: it has 5 heights, and the header promises 3 x 2"));
  EXPECT_TRUE(says(refused(header() + "1 2 3\n4 5 6 7\n"), "more heights than the 3 x 2"));
  EXPECT_TRUE(says(refused(header() + "1 2 x\n4 5 6\n"), "row 1, column 3 has \"x\""));
  EXPECT_TRUE(says(refused("ncols 3\nnrows 2\n" + kBody), "the header lacks cellsize"));
  EXPECT_TRUE(
      says(refused("ncols 3\ncellsize 1\nxllcorner 0\nyllcorner 0\n" + kBody), "lacks nrows"));
  EXPECT_TRUE(says(refused("ncols 3\nnrows two\n" + kBody), "\"two\" for nrows"));
  EXPECT_TRUE(says(refused("ncols 3\nnrows 1.5\n" + kBody), "1.5 for nrows"));
  EXPECT_TRUE(says(refused("ncols 2000000\nnrows 2\n" + kBody), "at most 1048576 a side"));
  EXPECT_TRUE(says(refused("ncols 1000000\nnrows 10000\n" + kBody), "only"));
  EXPECT_TRUE(says(refused("ncols 10000\nnrows 10000\n" + kBody), "the file has only"));
  EXPECT_TRUE(says(refused("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize -1\n" + kBody),
                   "sizes above 0"));
  EXPECT_TRUE(says(refused("ncols 3\nnrows 2\nheight 3\n" + kBody), "\"height\""));
}

TEST(Asc, ALargeFileStaysOnTheDisk) {
  std::string text = "ncols 7\nnrows 100\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  // Lines need not be rows.
  for (int i = 0; i < 700; ++i) {
    text += (i == 350 ? "-9999" : std::to_string(i) + ",5") + (i % 10 == 9 ? "\r\n" : "  ");
  }
  const auto bytes = memory_bytes({text.begin(), text.end()});
  const auto kept = read_asc(bytes, {}, "a.asc", {});
  const auto banded = read_asc(bytes, {}, "a.asc", {}, 64);
  EXPECT_NE(dynamic_cast<const MemoryRaster*>(kept.get()), nullptr);
  EXPECT_EQ(dynamic_cast<const MemoryRaster*>(banded.get()), nullptr);
  EXPECT_EQ(banded->info().notes, kept->info().notes);
  for (const Window& window : {Window{0, 0, 7, 100}, Window{3, 11, 2, 30}, Window{6, 99, 1, 1}}) {
    std::vector<float> a(static_cast<std::size_t>(window.width * window.height)), b(a.size());
    kept->read(window, a.data());
    banded->read(window, b.data());
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::isnan(a[i])) {
        EXPECT_TRUE(std::isnan(b[i]));
      } else {
        EXPECT_EQ(a[i], b[i]);
      }
    }
  }
  EXPECT_EQ(height_at(*banded, 6, 99), 699.5f);
  EXPECT_TRUE(std::isnan(height_at(*banded, 0, 50)));
}

TEST(Asc, ALongTextIsReadPieceByPiece) {
  std::string text = "ncols 1000\nnrows 400\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 400000; ++i) text += std::to_string(i) + ".5 ";
  const std::vector<float> heights = heights_of(*opened(text));
  for (int i = 0; i < 400000; ++i)
    ASSERT_EQ(heights[static_cast<std::size_t>(i)], static_cast<float>(i + 0.5));
}

}  // namespace
}  // namespace aerostat::elevation
