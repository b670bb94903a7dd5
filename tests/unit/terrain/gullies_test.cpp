#include "terrain/gullies.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace aerostat::terrain {
namespace {

/// Returns a plane that falls along (down_x, down_z), sampled at `points` and carved by `gullies`.
Slopes gullied_plane(const Gullies& gullies, const Points& points, float down_x, float down_z,
                     float strength = 1.0f) {
  Slopes ground;
  Block strengths;
  for (int i = 0; i < points.count; ++i) {
    ground.height[i] = -down_x * points.x[i] - down_z * points.z[i];
    ground.dx[i] = -down_x;
    ground.dz[i] = -down_z;
    strengths[i] = strength;
  }
  gullies.add(points, strengths, ground);
  return ground;
}

Points line(float x, float z, float step_x, float step_z, float spacing = 0.0f) {
  Points points;
  points.count = kBlockSize;
  for (int i = 0; i < points.count; ++i) {
    points.x[i] = x + step_x * static_cast<float>(i);
    points.z[i] = z + step_z * static_cast<float>(i);
    points.spacing[i] = spacing;
  }
  return points;
}

TEST(Gullies, RunDownTheFallLine) {
  const Gullies gullies(100.0, 1, 0.5f, 7u);
  const float down_x = 0.6f, down_z = 0.8f;
  double across = 0.0, along = 0.0;
  for (int n = 0; n < 40; ++n) {
    const auto start = static_cast<float>(137 * n);
    const Points a = line(start, -start, 5.0f * -down_z, 5.0f * down_x);
    const Points b = line(start, -start, 5.0f * down_x, 5.0f * down_z);
    const Slopes over = gullied_plane(gullies, a, down_x, down_z);
    const Slopes down = gullied_plane(gullies, b, down_x, down_z);
    for (int i = 1; i < kBlockSize; ++i) {
      across += std::fabs(over.height[i] - over.height[i - 1]);
      along += std::fabs(down.height[i] - down.height[i - 1] + 5.0f);
    }
  }
  EXPECT_GT(across, 2.0 * along);
}

TEST(Gullies, StayWithinTheirDepthAndSpareFlatGround) {
  const Gullies gullies(80.0, 1, 0.5f, 3u);
  const Points points = line(-900.0f, 41.0f, 13.7f, 5.1f);
  const Slopes ground = gullied_plane(gullies, points, 1.0f, 0.0f);
  float most = 0.0f;
  for (int i = 0; i < points.count; ++i)
    most = std::max(most, std::fabs(ground.height[i] + points.x[i]));
  // The depth from crest to floor is 0.5 * 80 m on ground of slope 1, divided by 1.35. Rounding the
  // crests lowers everything by 1 % of that.
  EXPECT_LT(most, 1.021f * 0.5f * 0.5f * 80.0f / 1.35f);
  EXPECT_GT(most, 0.3f * 0.5f * 80.0f / 1.35f);
  const Slopes flat = gullied_plane(gullies, points, 0.0f, 0.0f);
  for (int i = 0; i < points.count; ++i) EXPECT_EQ(flat.height[i], 0.0f);
  const Slopes none = gullied_plane(gullies, points, 1.0f, 0.0f, 0.0f);
  for (int i = 0; i < points.count; ++i) EXPECT_EQ(none.height[i], -points.x[i]);
}

TEST(Gullies, TooFineForTheSpacingAreLeftOut) {
  const Gullies gullies(80.0, 3, 0.5f, 3u);
  const Points points = line(0.0f, 0.0f, 40.0f, 3.0f, 40.0f);
  const Slopes ground = gullied_plane(gullies, points, 1.0f, 0.0f);
  for (int i = 0; i < points.count; ++i) EXPECT_EQ(ground.height[i], -points.x[i]);
}

TEST(Gullies, ReportTheSlopeOfWhatTheyAdd) {
  const Gullies gullies(100.0, 1, 0.5f, 11u);
  const float e = 0.25f;
  const Points points = line(-2000.0f, 700.0f, 31.3f, -17.9f);
  Points left = points, right = points;
  for (int i = 0; i < points.count; ++i) {
    left.z[i] -= e;
    right.z[i] += e;
  }
  // The plane falls along x, so the waves run along z.
  const Slopes ground = gullied_plane(gullies, points, 1.0f, 0.0f);
  const Slopes a = gullied_plane(gullies, left, 1.0f, 0.0f);
  const Slopes b = gullied_plane(gullies, right, 1.0f, 0.0f);
  double error = 0.0, size = 0.0;
  for (int i = 0; i < points.count; ++i) {
    const double slope = (b.height[i] - a.height[i]) / (2.0 * e);
    error += std::fabs(slope - ground.dz[i]);
    size += std::fabs(slope);
  }
  // Only the slope of the waves counts, not that of their blending.
  EXPECT_LT(error, 0.35 * size);
}

}  // namespace
}  // namespace aerostat::terrain
