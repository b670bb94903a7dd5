#include "elevation/raster.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace aerostat::elevation {
namespace {

TEST(MemoryRaster, ReadsTheWindowThatIsAskedFor) {
  RasterInfo info;
  info.width = 3;
  info.height = 2;
  const MemoryRaster raster(info, {0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f});
  std::vector<float> heights(2);
  raster.read({1, 1, 2, 1}, heights.data());
  EXPECT_EQ(heights, (std::vector<float>{4.0f, 5.0f}));
  raster.read({2, 0, 1, 2}, heights.data());
  EXPECT_EQ(heights, (std::vector<float>{2.0f, 5.0f}));
}

}  // namespace
}  // namespace aerostat::elevation
