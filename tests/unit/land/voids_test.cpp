#include "land/voids.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace aerostat::land {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

TEST(FillVoids, KeepsKnownHeightsAndStaysInTheirRange) {
  constexpr int kSide = 61;
  std::vector<float> heights;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const bool hole = i > 20 && i < 40 && j > 10 && j < 50;
      heights.push_back(hole ? kNone : 100.0f + static_cast<float>(i));
    }
  std::vector<float> filled = heights;
  fill_voids(kSide, kSide, filled);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (!std::isnan(heights[k])) {
      EXPECT_EQ(filled[k], heights[k]);
    }
    EXPECT_GE(filled[k], 100.0f);
    EXPECT_LE(filled[k], 160.0f);
  }
}

TEST(FillVoids, ContinuesASlopeAcrossAHole) {
  constexpr int kSide = 64;
  std::vector<float> heights(kSide * kSide);
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const bool hole = std::abs(i - 32) < 6 && std::abs(j - 32) < 6;
      heights[j * kSide + i] = hole ? kNone : 2.0f * static_cast<float>(i);
    }
  fill_voids(kSide, kSide, heights);
  for (int i = 26; i < 39; ++i) EXPECT_NEAR(heights[32 * kSide + i], 2.0 * i, 4.0) << i;
}

TEST(FillVoids, MakesARasterWithoutHeightsFlat) {
  std::vector<float> heights(12, kNone);
  fill_voids(4, 3, heights);
  EXPECT_TRUE(std::all_of(heights.begin(), heights.end(), [](float h) { return h == 0.0f; }));
}

TEST(FindVoids, TellsRegionsApart) {
  std::vector<float> heights(8 * 6, 1.0f);
  heights[2 * 8 + 3] = heights[2 * 8 + 4] = kNone;  // inside
  heights[0] = heights[8] = heights[16] = kNone;    // at the rim
  const VoidRegions found = find_voids(8, 6, heights);
  ASSERT_EQ(found.regions.size(), 2u);
  EXPECT_EQ(found.regions[0].cells, 3u);
  EXPECT_TRUE(found.regions[0].at_rim);
  EXPECT_EQ(found.regions[1].cells, 2u);
  EXPECT_FALSE(found.regions[1].at_rim);
  EXPECT_EQ(found.regions[1].width, 2);
  EXPECT_EQ(found.region_of[0], 0);
  EXPECT_EQ(found.region_of[2 * 8 + 4], 1);
  EXPECT_EQ(found.region_of[1], -1);
}

}  // namespace
}  // namespace aerostat::land
