#include "land/pyramid.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "rasters.hpp"

namespace aerostat::land {
namespace {

double hills(int i, int j) {
  return 500.0 + 80.0 * std::sin(0.31 * i) * std::cos(0.23 * j) + 0.377;
}

TEST(Pyramid, PassesThroughTheSamples) {
  const Pyramid pyramid(make_raster(80, 60, hills), {});
  for (int j = 3; j < 57; j += 5)
    for (int i = 3; i < 77; i += 7) {
      EXPECT_NEAR(pyramid.at(i, j, 1.0).height, hills(i, j), 0.01) << i << ", " << j;
    }
}

TEST(Pyramid, KeepsTheHeightOfASummit) {
  const Pyramid pyramid(
      make_raster(41, 41, [](int i, int j) { return 3000.5 - 40.1 * std::hypot(i - 20, j - 20); }),
      {});
  EXPECT_NEAR(pyramid.at(20, 20, 1.0).height, 3000.5, 0.5);
}

TEST(Pyramid, NeverOvershoots) {
  const Pyramid pyramid(make_raster(40, 40, [](int i, int) { return i < 20 ? 10.25 : 900.75; }),
                        {});
  for (double x = 0.0; x < 39.0; x += 0.1) {
    const float height = pyramid.at(x, 20.3, 1.0).height;
    EXPECT_GE(height, 10.25f);
    EXPECT_LE(height, 900.75f);
  }
}

TEST(Pyramid, GivesSlopesPerSample) {
  const Pyramid pyramid(make_raster(50, 50, [](int i, int j) { return 3.33 * i - 1.27 * j; }), {});
  for (const double samples : {1.0, 2.0, 3.0, 4.0}) {
    const SplinePoint point = pyramid.at(25.0, 24.0, samples);
    EXPECT_NEAR(point.along_columns, 3.33, 0.02) << samples;
    EXPECT_NEAR(point.along_rows, -1.27, 0.02) << samples;
    EXPECT_NEAR(point.height, 3.33 * 25.0 - 1.27 * 24.0, 0.05) << samples;
  }
}

TEST(Pyramid, AveragesOverLargeCells) {
  // Single samples differ, and their mean is 100.
  const Pyramid pyramid(
      make_raster(64, 64, [](int i, int j) { return (i + j) % 2 == 0 ? 90.37 : 109.63; }), {});
  EXPECT_NEAR(pyramid.at(31.0, 31.0, 8.0).height, 100.0, 0.01);
  EXPECT_NEAR(pyramid.at(31.0, 31.0, 1.0).height, 90.37, 0.01);
}

TEST(Pyramid, VoidsNeverEnterAverages) {
  const auto raster = make_raster(64, 64, [](int i, int j) {
    return i > 28 && i < 36 && j > 28 && j < 36 ? kVoid : 1000.4 + 0.1 * i;
  });
  const Pyramid pyramid(raster, {});
  EXPECT_EQ(pyramid.statistics().voids, 49u);
  EXPECT_EQ(pyramid.statistics().largest_void, 49u);
  EXPECT_FALSE(pyramid.statistics().void_at_rim);
  EXPECT_NEAR(pyramid.at(32.0, 32.0, 1.0).height, 1003.6, 1.0);
  EXPECT_NEAR(pyramid.at(32.0, 32.0, 32.0).height, 1003.6, 1.5);
  EXPECT_TRUE(pyramid.is_known(10.0, 10.0));
  EXPECT_FALSE(pyramid.is_known(32.0, 32.0));
  EXPECT_FALSE(pyramid.is_known(-1.0, 10.0));
}

TEST(Pyramid, LargeVoidsBecomeASeaIfAsked) {
  const auto raster = make_raster(100, 100, [](int i, int) { return i < 60 ? 12.25 : kVoid; });
  EXPECT_GT(Pyramid(raster, {}).at(90.0, 50.0, 1.0).height, 5.0f);
  PyramidOptions options;
  options.sea_depth_m = 25.0f;
  options.most_filled = 30;
  EXPECT_LT(Pyramid(raster, options).at(90.0, 50.0, 1.0).height, -20.0f);
}

TEST(Pyramid, GoesOnBeyondTheRimWithoutWalls) {
  const Pyramid pyramid(make_raster(64, 64, hills), {});
  double before = pyramid.at(63.0, 20.0, 1.0).height;
  for (double x = 63.0; x < 200.0; x += 0.5) {
    const double height = pyramid.at(x, 20.0, 1.0).height;
    EXPECT_LT(std::abs(height - before), 20.0) << x;
    before = height;
  }
  EXPECT_NEAR(before, 500.0, 30.0);  // the mean of the land
}

/// A raster of which only what is asked for is made, as in a huge file.
class Endless final : public elevation::Raster {
 public:
  explicit Endless(int side) : Raster(info_of(side)) {}

  static double height(int i, int j) {
    return 1000.0 + std::round(200.0 * std::sin(0.01 * i) * std::cos(0.013 * j));
  }

  void read(const elevation::Window& window, float* heights) const override {
    for (int j = 0; j < window.height; ++j)
      for (int i = 0; i < window.width; ++i) {
        *heights++ = static_cast<float>(height(window.column + i, window.row + j));
      }
  }

 private:
  static elevation::RasterInfo info_of(int side) {
    elevation::RasterInfo info;
    info.width = info.height = side;
    info.georeference = elevation::Georeference{};
    return info;
  }
};

TEST(Pyramid, ReadsFineTilesOfALargeRaster) {
  const Pyramid pyramid(std::make_shared<Endless>(5000), {});
  EXPECT_EQ(pyramid.statistics().samples, 25'000'000u);
  EXPECT_EQ(pyramid.step(), 1.0f);
  // Across the rims of tiles as well, single samples come back within half a step.
  for (int i = 240; i < 275; ++i) {
    EXPECT_NEAR(pyramid.at(i, 511.0, 1.0).height, Endless::height(i, 511), 0.51) << i;
  }
  double before = pyramid.at(250.0, 300.0, 1.0).height;
  for (double x = 250.0; x < 262.0; x += 0.05) {
    const double height = pyramid.at(x, 300.0, 1.0).height;
    EXPECT_LT(std::abs(height - before), 0.2) << x;
    before = height;
  }
}

}  // namespace
}  // namespace aerostat::land
