#include "land/flat_water.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

namespace aerostat::land {
namespace {

constexpr int kSide = 120;

std::vector<float> heights_of(const std::function<double(double, double)>& height, bool whole) {
  std::vector<float> heights;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const double value = height(i - 60.0, j - 60.0);
      heights.push_back(static_cast<float>(whole ? std::round(value) : value));
    }
  return heights;
}

FlatWaters waters_in(const std::function<double(double, double)>& height, bool whole = true,
                     bool has_sea = false) {
  return find_flat_water(kSide, kSide, heights_of(height, whole), {whole ? 1.0f : 0.0f, has_sea});
}

/// A bowl with slopes of one half whose floor of radius 12 is under water up to 500 m.
double bowl(double x, double z) {
  return 500.0 + std::max(0.0, 15.0 * (std::hypot(x, z) - 12.0));
}

TEST(FlatWater, FindsALakeInABowlWithItsLevel) {
  for (const bool whole : {true, false}) {
    const FlatWaters found = waters_in(bowl, whole);
    ASSERT_EQ(found.areas.size(), 1u);
    EXPECT_EQ(found.areas[0].level_m, 500.0f);
    EXPECT_NEAR(static_cast<double>(found.areas[0].cells), 3.14159 * 144.0, 25.0);
    EXPECT_EQ(found.level_m[60 * kSide + 60], 500.0f);
    EXPECT_TRUE(std::isnan(found.level_m[60 * kSide + 75]));
  }
}

TEST(FlatWater, TerracesOfWholeMetresAreNoLakes) {
  // Slopes of 1 : 10 to 1 : 30 in cells of a metre, straight and bent.
  EXPECT_TRUE(waters_in([](double x, double) { return 300.0 + 0.1 * x; }).areas.empty());
  EXPECT_TRUE(
      waters_in([](double x, double z) { return 300.0 + 0.05 * x + 0.03 * z; }).areas.empty());
  EXPECT_TRUE(waters_in([](double x, double z) {
                return 300.0 + 0.04 * x + 3.0 * std::sin(0.1 * z);
              }).areas.empty());
}

TEST(FlatWater, GentleHillsAndHollowsAreNoLakes) {
  const auto hollow = [](double x, double z) { return 300.0 + 0.002 * (x * x + z * z); };
  EXPECT_TRUE(waters_in(hollow).areas.empty());
  EXPECT_TRUE(waters_in([&](double x, double z) { return 600.0 - hollow(x, z); }).areas.empty());
}

TEST(FlatWater, FindsTheReachesOfARiver) {
  // A channel of 7 cells that falls by a metre every 40 cells, between banks.
  const FlatWaters found = waters_in([](double x, double z) {
    const double level = 200.0 - std::floor((x + 60.0) / 40.0);
    return std::abs(z) <= 3.0 ? level : level + 4.0 + 0.5 * std::abs(z);
  });
  ASSERT_EQ(found.areas.size(), 3u);
  EXPECT_EQ(found.areas[0].level_m, 200.0f);
  EXPECT_EQ(found.areas[1].level_m, 199.0f);
  EXPECT_EQ(found.areas[2].level_m, 198.0f);
}

TEST(FlatWater, HeightsAtOrBelowASeaAreTheSea) {
  const auto at_zero = [](double x, double z) { return bowl(x, z) - 500.0; };
  EXPECT_EQ(waters_in(at_zero).areas.size(), 1u);
  EXPECT_TRUE(waters_in(at_zero, true, true).areas.empty());
}

TEST(FlatWater, PondsOfAFewCellsAreLeftAlone) {
  const auto pond = [](double x, double z) {
    return 500.0 + std::max(0.0, 15.0 * (std::hypot(x, z) - 3.0));
  };
  EXPECT_TRUE(waters_in(pond).areas.empty());
}

TEST(FlatWater, VoidsAreNoShoreAndNoWater) {
  std::vector<float> heights = heights_of(bowl, true);
  for (std::size_t i = 0; i < 6; ++i) heights[60 * kSide + 57 + i] = std::nanf("");
  const FlatWaters found = find_flat_water(kSide, kSide, heights, {1.0f, false});
  ASSERT_EQ(found.areas.size(), 1u);
  EXPECT_TRUE(std::isnan(found.level_m[60 * kSide + 58]));
}

}  // namespace
}  // namespace aerostat::land
