#include "terrain/drainage.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace aerostat::terrain {
namespace {

DrainageOptions small_options() {
  DrainageOptions options;
  options.coarse_nodes = 17;
  options.rounds = {10, 6, 4};
  options.size_m = 10000.0;
  options.height_m = 800.0;
  return options;
}

// Makes the first row of a plateau of even uplift a coast.
void coast(const Points& points, Bedrock* rock) {
  for (int i = 0; i < points.count; ++i) {
    rock[i] = Bedrock{};
    rock[i].outlet = points.z[i] < -4999.0f;
  }
}

TEST(Drainage, EveryNodeHasALowerNeighbour) {
  const HeightGrid grid = carve_valleys(small_options(), coast);
  ASSERT_EQ(grid.nodes, 65);
  for (int j = 1; j < grid.nodes; ++j)
    for (int i = 0; i < grid.nodes; ++i) {
      float lowest = grid.values[grid.index(i, j)];
      for (int b = std::max(j - 1, 0); b <= std::min(j + 1, grid.nodes - 1); ++b)
        for (int a = std::max(i - 1, 0); a <= std::min(i + 1, grid.nodes - 1); ++a)
          lowest = std::min(lowest, grid.values[grid.index(a, b)]);
      EXPECT_LT(lowest, grid.values[grid.index(i, j)]) << i << ' ' << j;
    }
}

TEST(Drainage, LevelsThatAreLeftOutAreTheFinest) {
  DrainageOptions options = small_options();
  options.levels_left_out = 1;
  const HeightGrid grid = carve_valleys(options, coast);
  ASSERT_EQ(grid.nodes, 33);
  EXPECT_EQ(grid.x(grid.nodes - 1), 5000.0f);
  EXPECT_NEAR(*std::max_element(grid.values.begin(), grid.values.end()), 800.0f, 80.0f);
}

TEST(Drainage, OutletsStayAndPeaksReachTheHeight) {
  const HeightGrid grid = carve_valleys(small_options(), coast);
  for (int i = 0; i < grid.nodes; ++i) EXPECT_EQ(grid.values[grid.index(i, 0)], 0.0f);
  EXPECT_NEAR(*std::max_element(grid.values.begin(), grid.values.end()), 800.0f, 80.0f);
}

TEST(Drainage, ValleysDivideTheGround) {
  // A cone or a ramp would fall evenly along a row. Carved ground rises and falls.
  const HeightGrid grid = carve_valleys(small_options(), coast);
  const int row = grid.nodes / 3;
  int turns = 0;
  for (int i = 1; i + 1 < grid.nodes; ++i) {
    const float before = grid.values[grid.index(i, row)] - grid.values[grid.index(i - 1, row)];
    const float after = grid.values[grid.index(i + 1, row)] - grid.values[grid.index(i, row)];
    turns += before * after < 0.0f ? 1 : 0;
  }
  EXPECT_GE(turns, 6);
}

TEST(Drainage, ThreadsAndMissingOutletsDoNoHarm) {
  const auto build = [](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return carve_valleys(small_options(), [](const Points& points, Bedrock* rock) {
      std::fill_n(rock, points.count, Bedrock{});
    });
  };
  const HeightGrid one = build(1);
  EXPECT_EQ(one.values, build(2).values);
  for (const float value : one.values) ASSERT_TRUE(std::isfinite(value));
}

TEST(HeightGrid, SplineKeepsPlanesAndTheirSlope) {
  HeightGrid grid = make_grid(9, 800.0);
  for (int j = 0; j < grid.nodes; ++j)
    for (int i = 0; i < grid.nodes; ++i)
      grid.values[grid.index(i, j)] = 5.0f + 0.3f * grid.x(i) - 0.4f * grid.x(j);
  Points points;
  points.count = 2;
  points.x = {13.0f, -205.5f};
  points.z = {-77.0f, 148.0f};
  Block value, dx, dz;
  sample(grid, points, value, dx, dz);
  for (int k = 0; k < points.count; ++k) {
    EXPECT_NEAR(value[k], 5.0f + 0.3f * points.x[k] - 0.4f * points.z[k], 1e-3f);
    EXPECT_NEAR(dx[k], 0.3f, 1e-5f);
    EXPECT_NEAR(dz[k], -0.4f, 1e-5f);
  }
}

}  // namespace
}  // namespace aerostat::terrain
