#include "elevation/sentinels.hpp"

#include <gtest/gtest.h>

namespace aerostat::elevation {
namespace {

TEST(SentinelWarning, NamesUsualMarksFarFromTheRest) {
  EXPECT_EQ(sentinel_warning({-9999.0, 412.0, 300, 9700}),
            "300 samples have the value -9999, which is far from all others and often marks places "
            "without a height; set /terrain/nodata to -9999 if it does here.");
  EXPECT_NE(sentinel_warning({65535.0, 2900.0, 1, 9}).find("1 sample has"), std::string::npos);
  EXPECT_NE(sentinel_warning({-32768.0, -430.0, 5, 9}), "");
  EXPECT_NE(sentinel_warning({32767.0, 4000.0, 5, 9}), "");
}

TEST(SentinelWarning, IsEmptyForHeights) {
  EXPECT_EQ(sentinel_warning({0.0, 1500.0, 300, 9700}), "");      // the sea below a cliff
  EXPECT_EQ(sentinel_warning({-9999.0, -9998.0, 1, 9700}), "");   // the floor of a trench
  EXPECT_EQ(sentinel_warning({-10000.0, 400.0, 300, 9700}), "");  // no usual mark
  EXPECT_EQ(sentinel_warning({-9999.0, 412.0, 300, 0}), "");      // all samples are alike
}

}  // namespace
}  // namespace aerostat::elevation
