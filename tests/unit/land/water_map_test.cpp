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

// Tests that waters far from each other are parts of one map, and what lies between them.
TEST(WaterMap, KnowsNothingFarFromWater) {
  constexpr int kWidth = 640, kHeight = 320;
  WetCells cells{kWidth, kHeight, 2, {}};
  for (int j = 0; j < kHeight; ++j)
    for (int i = 0; i < kWidth; ++i) {
      const bool west = std::hypot(i - 40.0, j - 50.0) < 12.0;
      const bool east = std::hypot(i - 600.0, j - 280.0) < 9.0;
      cells.level_m.push_back(west ? 300.0f : east ? 500.0f : kDry);
    }
  const WaterMap map(cells);
  const auto at = [&](double column, double row, double spacing) {
    return map.at(2.0 * column + 0.5, 2.0 * row + 0.5, 2.0 * spacing);
  };
  EXPECT_FLOAT_EQ(at(40.0, 50.0, 1.0).level_m, 300.0f);
  EXPECT_FLOAT_EQ(at(600.0, 280.0, 1.0).level_m, 500.0f);
  EXPECT_NEAR(at(40.0, 50.0, 1.0).shore, 24.0, 3.0);
  EXPECT_NEAR(at(600.0, 280.0, 1.0).shore, 18.0, 3.0);
  for (const double spacing : {1.0, 4.0, 16.0, 1000.0}) {
    EXPECT_TRUE(std::isnan(at(320.0, 160.0, spacing).level_m)) << spacing;
    EXPECT_LT(at(320.0, 160.0, spacing).shore, -100.0f) << spacing;
  }
  // A mesh of cells 16 times as wide finds the shore of the lake in the west.
  EXPECT_FLOAT_EQ(at(40.0 + 12.0 + 48.0, 50.0, 16.0).level_m, 300.0f);
  const auto is_near = [&](dvec2 least, dvec2 most) {
    return map.is_near(2.0 * least, 2.0 * most);
  };
  EXPECT_TRUE(is_near({0.0, 0.0}, {40.0, 50.0}));
  EXPECT_TRUE(is_near({590.0, 200.0}, {1000.0, 1000.0}));
  EXPECT_TRUE(is_near({30.0, 0.0}, {31.0, 319.0}));
  EXPECT_FALSE(is_near({300.0, 0.0}, {400.0, 319.0}));
}

}  // namespace
}  // namespace aerostat::land
