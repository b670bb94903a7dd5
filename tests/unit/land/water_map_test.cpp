#include "land/water_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace aerostat::land {
namespace {

constexpr float kDry = std::numeric_limits<float>::quiet_NaN();

/// Returns a map of 64 x 64 cells. `level` is that of the water at a cell, or NaN.
template <class Level>
WaterMap map_of(const Level& level, int samples_a_cell = 1) {
  WetCells cells{64, 64, samples_a_cell, {}};
  for (int j = 0; j < 64; ++j)
    for (int i = 0; i < 64; ++i) cells.level_m.push_back(level(i, j));
  return WaterMap(cells);
}

float disc(int i, int j) {
  return std::hypot(i - 31.5, j - 31.5) <= 20.0 ? 700.0f : kDry;
}

TEST(WaterMap, MeasuresTheDistanceFromTheShore) {
  const WaterMap map = map_of(disc);
  EXPECT_NEAR(map.at(31.5, 31.5, 1.0).shore, 20.0, 2.0);
  EXPECT_NEAR(map.at(31.5 + 10.0, 31.5, 1.0).shore, 10.0, 1.0);
  EXPECT_NEAR(map.at(31.5 + 26.0, 31.5, 1.0).shore, -6.0, 0.7);
  EXPECT_EQ(map.at(31.5, 31.5, 1.0).level_m, 700.0f);
  EXPECT_TRUE(std::isnan(map.at(2.0, 2.0, 1.0).level_m));
}

// Tests that the shore is a smooth line and no staircase of cells.
TEST(WaterMap, TheShoreOfADiscIsRound) {
  const WaterMap map = map_of(disc);
  double least = 1e9, greatest = 0.0;
  for (double turn = 0.0; turn < 6.28; turn += 0.02) {
    double radius = 15.0;
    while (map.at(31.5 + radius * std::cos(turn), 31.5 + radius * std::sin(turn), 1.0).shore > 0.0f)
      radius += 0.02;
    least = std::min(least, radius);
    greatest = std::max(greatest, radius);
  }
  EXPECT_NEAR(0.5 * (least + greatest), 20.0, 0.4);
  EXPECT_LT(greatest - least, 0.55);  // cells have steps of 1 to 1.4
}

TEST(WaterMap, ReachesOfARiverPassIntoOneAnother) {
  const WaterMap map = map_of(
      [](int i, int j) { return std::abs(j - 32) <= 4 ? (i < 32 ? 101.0f : 100.0f) : kDry; });
  EXPECT_FLOAT_EQ(map.at(20.0, 32.0, 1.0).level_m, 101.0f);
  EXPECT_FLOAT_EQ(map.at(44.0, 32.0, 1.0).level_m, 100.0f);
  EXPECT_NEAR(map.at(31.5, 32.0, 1.0).level_m, 100.5f, 0.01f);
  EXPECT_GT(map.at(31.5, 32.0, 1.0).shore, 3.0f);  // there is no shore between them
}

TEST(WaterMap, NarrowWaterFadesFromCoarseLayers) {
  const WaterMap map = map_of([](int i, int) { return i >= 30 && i < 34 ? 50.0f : kDry; });
  EXPECT_GT(map.at(31.5, 20.0, 1.0).shore, 1.0f);
  EXPECT_LT(map.at(31.5, 20.0, 32.0).shore, 0.0f);
}

TEST(WaterMap, EndsAtTheRimOfTheRaster) {
  const WaterMap map = map_of([](int, int) { return 10.0f; }, 4);
  EXPECT_GT(map.at(100.0, 100.0, 1.0).shore, 50.0f);
  EXPECT_NEAR(map.at(0.5, 100.0, 1.0).shore, 1.0f, 0.01f);
  EXPECT_LT(map.at(-3.0, 100.0, 1.0).shore, 0.0f);
  EXPECT_LT(map.at(100.0, 260.0, 1.0).shore, 0.0f);
}

}  // namespace
}  // namespace aerostat::land
