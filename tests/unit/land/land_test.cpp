#include "land/land.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "geo/transform.hpp"
#include "land/land_notes.hpp"

namespace aerostat::land {
namespace {

namespace fs = std::filesystem;

/// A folder of small files for one test.
class LandFiles : public ::testing::Test {
 protected:
  LandFiles()
      : folder_(fs::temp_directory_path() /
                (std::string("aerostat-land-") +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
  }
  ~LandFiles() override { fs::remove_all(folder_); }

  /// Writes an .asc file of whole metres in UTM zone 32.
  fs::path write(const std::string& name, int side, double west, double south, double cell,
                 double (*height)(int column, int row), const std::string& crs = "EPSG:32632") {
    const fs::path path = folder_ / name;
    std::ofstream file(path);
    file << "ncols " << side << "\nnrows " << side << "\nxllcenter " << west << "\nyllcenter "
         << south << "\ncellsize " << cell << "\nNODATA_value -9999\n";
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) file << height(i, j) << ' ';
      file << '\n';
    }
    options_.sources.push_back(path);
    options_.open.crs = crs;
    return path;
  }

  /// Returns the height at a point of the local frame.
  static float height_at(const LocalLand& land, float east, float south, float spacing = 1.0f) {
    float height = 0.0f, dx = 0.0f, dz = 0.0f;
    land.sample({{&east, 1}, {&south, 1}, {&spacing, 1}, {&height, 1}, {&dx, 1}, {&dz, 1}});
    return height;
  }

  fs::path folder_;
  LandOptions options_;
};

double corner(int column, int row) {
  return column == 90 && row == 10 ? 2000.0 : 700.25 + 0.5 * column;
}

TEST_F(LandFiles, NorthIsNorthAndEastIsEast) {
  write("a.asc", 101, 500000.0, 5200000.0, 100.0, corner);  // on the central meridian
  const Land land(options_);
  ASSERT_TRUE(land.has_place());
  EXPECT_NEAR(land.middle().place->longitude_deg, 9.065, 0.01);
  EXPECT_NEAR(land.cell_m(), 100.04, 0.05);  // UTM is 0.9996 of the truth
  EXPECT_NEAR(land.size_m().x, 10104.0, 10.0);
  EXPECT_EQ(land.highest_m(), 2000.0f);
  // The peak lies 40 samples to the east and 40 to the north of the middle.
  const auto local = land.around(land.middle(), 6000.0);
  EXPECT_GT(height_at(*local, 4001.6f, -4001.6f), 1900.0f);
  EXPECT_LT(height_at(*local, -4001.6f, -4001.6f), 800.0f);
  EXPECT_LT(height_at(*local, 4001.6f, 4001.6f), 800.0f);
  EXPECT_TRUE(local->is_known(0.0, 0.0));
  EXPECT_FALSE(local->is_known(5900.0, 0.0));
}

/// A lake of radius 1200 m, 2000 m to the east and 2000 m to the north of the middle, in a bowl.
double bowl(int column, int row) {
  return 600.0 + std::max(0.0, 8.0 * (std::hypot(column - 70.0, row - 30.0) - 12.0));
}

TEST_F(LandFiles, ALakeLiesAtItsPlaceInTheFrame) {
  write("a.asc", 101, 500000.0, 5200000.0, 100.0, bowl);
  const Land land(options_);
  ASSERT_EQ(land.waters().size(), 1u);
  const auto local = land.around(land.middle(), 6000.0);
  const auto level_at = [&](float east, float south) {
    const float spacing = 10.0f;
    float level = 0.0f, shore = 0.0f;
    local->find_water({{&east, 1}, {&south, 1}, {&spacing, 1}, {&level, 1}, {&shore, 1}});
    return level;
  };
  EXPECT_FLOAT_EQ(level_at(2000.0f, -2000.0f), 600.0f);
  EXPECT_FLOAT_EQ(level_at(3000.0f, -2000.0f), 600.0f);
  EXPECT_TRUE(std::isnan(level_at(-4000.0f, 4000.0f)));
}

TEST_F(LandFiles, APlaceMovesTheFrame) {
  write("a.asc", 101, 500000.0, 5200000.0, 100.0, corner);
  const Land land(options_);
  const dvec2 peak = {509000.0, 5209000.0};
  const LandPoint point{geo::place_of("EPSG:32632", peak), {}};
  EXPECT_GT(height_at(*land.around(point, 2000.0), 0.0f, 0.0f), 1990.0f);
}

TEST_F(LandFiles, TilesJoinWithoutASeam) {
  const auto plain = [](int column, int row) { return 800.0 + column - row; };
  const auto next = [](int column, int row) { return 800.0 + column + 50.0 - row; };
  write("a.asc", 51, 500000.0, 5200000.0, 30.0, plain);
  write("b.asc", 51, 501500.0, 5200000.0, 30.0, next);
  const Land land(options_);
  EXPECT_EQ(land.pyramids().size(), 1u);
  EXPECT_EQ(land.files().size(), 2u);
  const auto local = land.around(land.middle(), 2000.0);
  float before = height_at(*local, -100.0f, 0.0f);
  for (float x = -100.0f; x < 100.0f; x += 5.0f) {
    const float height = height_at(*local, x, 0.0f);
    EXPECT_LT(std::abs(height - before), 0.4f) << x;
    before = height;
  }
}

TEST_F(LandFiles, RastersOnOtherGridsBlendAtTheRim) {
  write("fine.asc", 101, 500000.0, 5200000.0, 10.0, [](int, int) { return 900.0; });
  write("coarse.asc", 101, 499000.0, 5199000.0, 40.0, [](int, int) { return 950.0; });
  const Land land(options_);
  ASSERT_EQ(land.pyramids().size(), 2u);
  const auto local = land.around(land.middle(), 4000.0);
  EXPECT_NEAR(height_at(*local, 0.0f, 0.0f), 900.0, 0.6);     // the first one wins
  EXPECT_NEAR(height_at(*local, 1500.0f, 0.0f), 950.0, 0.6);  // beyond it
  float before = height_at(*local, 300.0f, 0.0f);
  for (float x = 300.0f; x < 700.0f; x += 2.0f) {
    const float height = height_at(*local, x, 0.0f);
    EXPECT_LT(std::abs(height - before), 2.5f) << x;
    before = height;
  }
}

TEST_F(LandFiles, NumbersThatCouldBeDegreesNeedASystem) {
  write(
      "a.asc", 20, 9.6, 46.5, 0.0003, [](int, int) { return 1000.0; }, "");
  try {
    const Land land(options_);
    FAIL() << "degrees were taken as metres";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_NE(std::string(error.what()).find("/terrain/crs"), std::string::npos) << error.what();
  }
}

TEST_F(LandFiles, MetresWithoutASystemAreSaid) {
  write(
      "a.asc", 20, 180000.0, 380000.0, 5.0, [](int, int) { return 1000.0; }, "");
  const Land land(options_);
  EXPECT_FALSE(land.has_place());
  bool said = false;
  for (const std::string& note : land.notes())
    said |= note.find("taken as metres") != std::string::npos;
  EXPECT_TRUE(said);
}

TEST_F(LandFiles, FeetAndSentinelsAreSuspected) {
  write("feet.asc", 30, 500000.0, 5200000.0, 30.0, [](int i, int) { return 9000.0 + 100.0 * i; });
  write("low.asc", 30, 600000.0, 5200000.0, 30.0,
        [](int i, int j) { return i == 3 && j == 4 ? -32768.0 : 1200.0; });
  const Land land(options_);
  std::string all;
  for (const std::string& note : land.notes()) all += note + "\n";
  EXPECT_NE(all.find("/terrain/unit=ft"), std::string::npos) << all;
  EXPECT_NE(all.find("/terrain/nodata to -32768"), std::string::npos) << all;
}

TEST(DatumNote, NamesFilesWhoseHeightsCountFromOtherLevels) {
  std::vector<elevation::RasterInfo> files(3);
  files[0].path = "tiles/a.tif";
  files[1].path = "tiles/b.tif";
  files[2].path = "tiles/c.tif";
  EXPECT_EQ(datum_note(files), "");
  files[1].vertical_datum = "EGM96 height";
  EXPECT_EQ(datum_note(files), "");
  files[2].vertical_datum = "NAVD88 height";
  const std::string note = datum_note(files);
  for (const char* word : {"b.tif", "EGM96 height", "c.tif", "NAVD88 height"}) {
    EXPECT_NE(note.find(word), std::string::npos) << note;
  }
  files[2].vertical_datum = "EGM96 height";
  EXPECT_EQ(datum_note(files), "");
}

TEST_F(LandFiles, KnowsASeaByItsLevel) {
  write("coast.asc", 50, 500000.0, 5200000.0, 30.0,
        [](int i, int) { return i < 25 ? 0.0 : 4.0 * (i - 24); });
  EXPECT_TRUE(Land(options_).has_sea());
  options_.sources.clear();
  // Land below the sea's level, such as on the shore of the Dead Sea, is dry.
  write("low.asc", 50, 500000.0, 5200000.0, 30.0, [](int i, int) { return -430.5 + 10.0 * i; });
  EXPECT_FALSE(Land(options_).has_sea());
  options_.sources.clear();
  write("deep.asc", 50, 500000.0, 5200000.0, 30.0, [](int i, int) { return -2000.0 + 100.0 * i; });
  EXPECT_TRUE(Land(options_).has_sea());
}

}  // namespace
}  // namespace aerostat::land
