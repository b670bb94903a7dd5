#include "land/mosaic.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "rasters.hpp"

namespace aerostat::land {
namespace {

double slope(double i, double j) {
  return 100.0 + 2.0 * i + 3.0 * j;
}

TEST(Joined, TilesThatShareARowOfSamplesBecomeOneRaster) {
  const auto west = make_raster(11, 11, [](int i, int j) { return slope(i, j); });
  const auto east =
      make_raster(11, 11, [](int i, int j) { return slope(i + 10, j); }, {100.0, 0.0});
  const auto south =
      make_raster(11, 11, [](int i, int j) { return slope(i, j + 10); }, {0.0, -100.0});
  const auto all = joined({east, west, south});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0]->info().width, 21);
  EXPECT_EQ(all[0]->info().height, 21);
  EXPECT_EQ(all[0]->info().georeference->origin, dvec2(0.0));
  std::vector<float> heights(21 * 21);
  all[0]->read({0, 0, 21, 21}, heights.data());
  for (int j = 0; j < 21; ++j)
    for (int i = 0; i < 21; ++i) {
      const float height = heights[j * 21 + i];
      if (i > 10 && j > 10) {
        EXPECT_TRUE(std::isnan(height));  // no file is there
      } else {
        EXPECT_FLOAT_EQ(height, static_cast<float>(slope(i, j))) << i << ", " << j;
      }
    }
  std::vector<float> part(3);
  all[0]->read({9, 4, 3, 1}, part.data());
  EXPECT_FLOAT_EQ(part[0], static_cast<float>(slope(9, 4)));
  EXPECT_FLOAT_EQ(part[2], static_cast<float>(slope(11, 4)));
}

TEST(Joined, TheFirstWithAHeightWins) {
  const auto first = make_raster(4, 1, [](int i, int) { return i == 2 ? kVoid : 1.0; });
  const auto second = make_raster(4, 1, [](int, int) { return 2.0; });
  const auto all = joined({first, second});
  ASSERT_EQ(all.size(), 1u);
  std::vector<float> heights(4);
  all[0]->read({0, 0, 4, 1}, heights.data());
  EXPECT_EQ(heights, (std::vector<float>{1.0f, 1.0f, 2.0f, 1.0f}));
}

TEST(Joined, RastersOnOtherGridsStayApart) {
  const auto first = make_raster(8, 8, slope);
  const auto coarse = make_raster(8, 8, slope, dvec2(0.0), 30.0);
  const auto shifted = make_raster(8, 8, slope, {4.0, 0.0});
  EXPECT_EQ(joined({first, coarse, shifted}).size(), 3u);
  // A hundredth of a sample is no other grid.
  EXPECT_EQ(joined({first, make_raster(8, 8, slope, {80.1, 0.0})}).size(), 1u);
}

}  // namespace
}  // namespace aerostat::land
