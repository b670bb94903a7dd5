#include "terrain/scree.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

namespace aerostat::terrain {
namespace {

/// Returns ground with uneven lines under steps, spikes and slopes.
GradedHeights rough_ground(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  GradedHeights ground;
  float at = -1000.0f;
  for (int i = 0; i < 120; ++i) ground.lines.push_back(at += 8.0f + 12.0f * unit(random));
  for (int j = 0; j < ground.stride(); ++j)
    for (int i = 0; i < ground.stride(); ++i) {
      const float step = std::floor(0.004f * ground.lines[i] + 0.002f * ground.lines[j]);
      ground.values.push_back(120.0f * step + 0.2f * ground.lines[j] + 15.0f * unit(random));
    }
  return ground;
}

TEST(Scree, LiesNoSteeperThanTheAngleOfRepose) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const GradedHeights before = rough_ground(seed);
    GradedHeights after = before;
    lay_scree(after, 0.5f);
    const int stride = after.stride();
    int raised = 0;
    for (int j = 1; j + 1 < stride; ++j)
      for (int i = 1; i + 1 < stride; ++i) {
        const int n = j * stride + i;
        ASSERT_GE(after.values[n], before.values[n]);
        if (after.values[n] == before.values[n]) continue;
        ++raised;
        for (int dj = -1; dj <= 1; ++dj)
          for (int di = -1; di <= 1; ++di) {
            const float distance = std::hypot(after.lines[i + di] - after.lines[i],
                                              after.lines[j + dj] - after.lines[j]);
            const float drop = after.values[n] - after.values[n + dj * stride + di];
            ASSERT_LE(drop, kScreeTangent * distance + 1e-3f) << i << " " << j;
          }
      }
    EXPECT_GT(raised, 1000) << seed;
    EXPECT_LT(raised, stride * stride) << seed;
  }
}

// Tests a straight wall on level ground. Its apron has one slope, and its top and foot are known.
TEST(Scree, OfAWallClimbsToItsShareOfTheHeight) {
  GradedHeights ground;
  for (int i = 0; i < 41; ++i) ground.lines.push_back(10.0f * static_cast<float>(i));
  for (int j = 0; j < 41; ++j)
    for (int i = 0; i < 41; ++i) ground.values.push_back(i < 20 ? 0.0f : 100.0f);
  lay_scree(ground, 0.4f);
  // Columns 19 and 20 are steep. The scree begins at 0 + 0.4 * 0 at the foot and at 0.4 * 100 at
  // the edge.
  for (int i = 1; i < 20; ++i) {
    const float expected = std::max(40.0f - 7.0f * static_cast<float>(20 - i), 0.0f);
    EXPECT_NEAR(ground.values[20 * 41 + i], expected, 1e-3f) << i;
  }
  EXPECT_EQ(ground.values[20 * 41 + 20], 100.0f);
}

TEST(Scree, LeavesGentleGroundAndAShareOfNothingAlone) {
  GradedHeights gentle = rough_ground(4);
  for (float& value : gentle.values) value *= 0.02f;
  GradedHeights after = gentle;
  lay_scree(after, 1.0f);
  EXPECT_EQ(after.values, gentle.values);
  const GradedHeights before = rough_ground(5);
  after = before;
  lay_scree(after, 0.0f);
  EXPECT_EQ(after.values, before.values);
}

}  // namespace
}  // namespace aerostat::terrain
