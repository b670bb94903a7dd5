// Tests the rays of each lens in closed form.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "camera.h"
#include "probe.hpp"

namespace aerostat::test {
namespace {

using Word = std::uint32_t;

constexpr Word kWidth = 32, kHeight = 16, kSamples = 16;
constexpr float kAperture = 0.4f, kFocus = 7.5f;
constexpr double kPi64 = std::numbers::pi;

/// Returns a frame that looks along -z from (1, 2, 3). A pixel is a quarter of the unit of depth
/// wide.
AeroFrame frame_of(Word lens) {
  AeroFrame frame{};
  AeroCamera& camera = frame.camera;
  camera = {{1, 2, 3},  {-4, 2, -1}, {0.25f, 0, 0}, {0, -0.25f, 0}, {1, 0, 0}, {0, 1, 0},
            {0, 0, -1}, kAperture,   kFocus,        0.0f,           lens};
  if (lens == AERO_LENS_ORTHOGRAPHIC) camera.corner[2] = 0.0f;
  frame.width = kWidth;
  frame.height = kHeight;
  frame.samples = kSamples;
  frame.sample_spread = 1.0f;
  frame.sample_stride = 5;
  frame.sample_shift = 0x12345678u;
  return frame;
}

struct Rays {
  std::vector<vec3> origins, directions;
  std::vector<Word> x, y;
};

class Lens : public LaneTest {
 protected:
  /// Returns one ray of every pixel.
  Rays trace(const AeroFrame& frame, Word sample) const;

 private:
  const Probe probe_{"camera.cl", GetParam()};
};

Rays Lens::trace(const AeroFrame& frame, Word sample) const {
  const auto log2_lanes = static_cast<Word>(std::bit_width(static_cast<Word>(GetParam()))) - 1;
  AeroLaunch launch{frame, {0, 0, kWidth, kHeight, 0, 0, sample, log2_lanes, 0, 0}, {}};
  launch.tile.blocks_per_row = kWidth >> log2_lanes;
  launch.tile.block_count = launch.tile.blocks_per_row * kHeight;
  const std::size_t count = kWidth * kHeight;
  const auto origin = output<float>(3 * count), direction = output<float>(3 * count);
  const auto t_max = output<float>(count);
  probe_.run("probe_rays", count, launch, origin, direction, t_max);
  const auto x = output<Word>(count), y = output<Word>(count), number = output<Word>(count);
  const auto active = output<int>(count);
  probe_.run("probe_packets", count, launch.tile, x, y, number, active);
  const auto origins = origin.read(), directions = direction.read();
  Rays rays{{}, {}, x.read(), y.read()};
  for (std::size_t i = 0; i < count; ++i) {
    rays.origins.push_back(from_planes(origins, i));
    rays.directions.push_back(from_planes(directions, i));
  }
  return rays;
}

AEROSTAT_AT_EVERY_WIDTH(Lens);

void expect_near(const dvec3& actual, const dvec3& expected, double tolerance) {
  EXPECT_LT(glm::distance(actual, expected), tolerance)
      << actual.x << ", " << actual.y << ", " << actual.z << " for " << expected.x << ", "
      << expected.y << ", " << expected.z;
}

TEST_P(Lens, WithoutAnApertureIsAPinhole) {
  AeroFrame thin = frame_of(AERO_LENS_THIN);
  thin.camera.aperture = 0.0f;
  for (Word sample = 0; sample < kSamples; ++sample) {
    const Rays expected = trace(frame_of(AERO_LENS_PINHOLE), sample), found = trace(thin, sample);
    for (std::size_t i = 0; i < found.origins.size(); ++i) {
      EXPECT_EQ(found.origins[i], vec3(1, 2, 3));
      expect_near(found.directions[i], expected.directions[i], 4e-7);
    }
  }
}

/// Tests that every ray of an image point crosses the sharp plane at the same point as the ray
/// through the middle of the lens.
TEST_P(Lens, RaysOfAnImagePointMeetOnTheSharpPlane) {
  double farthest = 0.0;
  for (Word sample = 0; sample < kSamples; ++sample) {
    const Rays middle = trace(frame_of(AERO_LENS_PINHOLE), sample);
    const Rays rays = trace(frame_of(AERO_LENS_THIN), sample);
    for (std::size_t i = 0; i < rays.origins.size(); ++i) {
      const auto at_focus = [](const dvec3& origin, const dvec3& direction) {
        return origin + direction * (static_cast<double>(kFocus) / -direction.z);
      };
      expect_near(at_focus(rays.origins[i], rays.directions[i]),
                  at_focus(middle.origins[i], middle.directions[i]), 2e-5);
      const vec3 offset = rays.origins[i] - vec3(1, 2, 3);
      EXPECT_EQ(offset.z, 0.0f) << "the lens lies across the axis";
      farthest = std::max(farthest, static_cast<double>(glm::length(offset)));
    }
  }
  EXPECT_LE(farthest, static_cast<double>(kAperture) * 1.000001);
  EXPECT_GT(farthest, static_cast<double>(kAperture) * 0.98);
}

/// Tests that samples fill the lens evenly by area. The square of the radius and the azimuth are
/// evenly distributed, and no side is preferred, not even in a single pixel.
TEST_P(Lens, FillsItsDiscEvenly) {
  std::vector<vec3> sums(kWidth * kHeight, vec3(0.0f));
  std::array<int, 4> rings{}, sectors{};
  for (Word sample = 0; sample < kSamples; ++sample) {
    const Rays rays = trace(frame_of(AERO_LENS_THIN), sample);
    for (std::size_t i = 0; i < rays.origins.size(); ++i) {
      const vec3 at = (rays.origins[i] - vec3(1, 2, 3)) / kAperture;
      sums[rays.y[i] * kWidth + rays.x[i]] += at / static_cast<float>(kSamples);
      const double area = static_cast<double>(glm::dot(at, at));
      ++rings[std::min<std::size_t>(3, static_cast<std::size_t>(4.0 * area))];
      ++sectors[(at.x > 0.0f ? 1u : 0u) + (at.y > 0.0f ? 2u : 0u)];
    }
  }
  // Every square of 4 x 4 pixels has the same 256 points. One in sixteen of a quarter may stray.
  const double quarter = kWidth * kHeight * kSamples / 4.0;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(rings[i], quarter, 0.06 * quarter) << "ring " << i;
    EXPECT_NEAR(sectors[i], quarter, 0.06 * quarter) << "sector " << i;
  }
  // 16 independent points would stray by 0.125 on each axis, and some pixels by three times that.
  for (const vec3& sum : sums) EXPECT_LT(glm::length(sum), 0.2f);
}

TEST_P(Lens, PanoramaShowsAllDirections) {
  AeroFrame frame = frame_of(AERO_LENS_PANORAMA);
  frame.samples = 1;
  const Rays rays = trace(frame, 0);
  dvec3 solid(0.0);
  double sphere = 0.0;
  for (std::size_t i = 0; i < rays.directions.size(); ++i) {
    const double azimuth = 2.0 * kPi64 * ((rays.x[i] + 0.5) / kWidth - 0.5);
    const double height = kPi64 * (0.5 - (rays.y[i] + 0.5) / kHeight);
    // Ahead is -z, and right is +x.
    const dvec3 expected(std::cos(height) * std::sin(azimuth), std::sin(height),
                         -std::cos(height) * std::cos(azimuth));
    expect_near(rays.directions[i], expected, 1e-6);
    EXPECT_EQ(rays.origins[i], vec3(1, 2, 3));
    // The share of a pixel in the sphere is proportional to the cosine of its height.
    solid += dvec3(rays.directions[i]) * std::cos(height);
    sphere += std::cos(height);
  }
  EXPECT_LT(glm::length(solid) / sphere, 1e-5) << "opposite directions balance";
}

TEST_P(Lens, OrthographicRaysAreParallelAndEvenlyApart) {
  AeroFrame frame = frame_of(AERO_LENS_ORTHOGRAPHIC);
  frame.samples = 1;
  const Rays rays = trace(frame, 0);
  for (std::size_t i = 0; i < rays.directions.size(); ++i) {
    EXPECT_EQ(rays.directions[i], vec3(0, 0, -1));
    expect_near(rays.origins[i],
                {1.0 - 4.0 + 0.25 * (rays.x[i] + 0.5), 2.0 + 2.0 - 0.25 * (rays.y[i] + 0.5), 3.0},
                1e-6);
  }
}

}  // namespace
}  // namespace aerostat::test
