// Tests the pixel and the sample of each lane, the place in the pixel, and the ray through it.
#include "camera.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>

#include "probe.hpp"

namespace aerostat::test {
namespace {

using Word = std::uint32_t;

AeroTile tile_of(Word x0, Word y0, Word x1, Word y1, Word log2_w, Word log2_h, Word log2_samples) {
  AeroTile tile{x0, y0, x1, y1, 0, 0, 0, log2_w, log2_h, log2_samples};
  tile.blocks_per_row = (x1 - x0 + (1u << log2_w) - 1) >> log2_w;
  tile.block_count = tile.blocks_per_row * ((y1 - y0 + (1u << log2_h) - 1) >> log2_h);
  return tile;
}

/// Returns a frame that looks along -z from (1, 2, 3). It spans 90 degrees across an image twice as
/// wide as high.
AeroFrame frame_of(Word width, Word height, Word samples) {
  AeroFrame frame{};
  const float step = 2.0f / static_cast<float>(width);
  frame.camera = {{1, 2, 3},        {-1.0f, 0.5f, -1.0f}, {step, 0, 0}, {0, -step, 0}, {1, 0, 0},
                  {0, 1, 0},        {0, 0, -1},           0.0f,         1.0f,          0.0f,
                  AERO_LENS_PINHOLE};
  frame.width = width;
  frame.height = height;
  frame.sample_stride = 37;
  frame.sample_shift = 0x12345678u;
  frame.samples = samples;
  frame.sample_spread = 1.0f;
  return frame;
}

class Camera : public LaneTest {
 protected:
  const Probe probe{"camera.cl", GetParam()};
  const Word log2_lanes = static_cast<Word>(std::bit_width(static_cast<Word>(GetParam()))) - 1;

  void expect_every_sample_once(const AeroTile& tile) const;
};

void Camera::expect_every_sample_once(const AeroTile& tile) const {
  const std::size_t count = std::size_t{tile.block_count} << log2_lanes;
  const auto x = output<Word>(count), y = output<Word>(count), sample = output<Word>(count);
  const auto active = output<int>(count);
  probe.run("probe_packets", count, tile, x, y, sample, active);
  const auto xs = x.read(), ys = y.read(), samples = sample.read();
  const auto on = active.read();
  std::map<std::tuple<Word, Word, Word>, int> seen;
  for (std::size_t i = 0; i < count; ++i) {
    const bool inside = xs[i] < tile.x1 && ys[i] < tile.y1;
    ASSERT_EQ(on[i], inside ? -1 : 0) << i;
    if (inside) ++seen[{xs[i], ys[i], samples[i]}];
  }
  const Word per_pixel = 1u << tile.log2_samples;
  ASSERT_EQ(seen.size(), std::size_t{tile.x1 - tile.x0} * (tile.y1 - tile.y0) * per_pixel);
  for (const auto& [place, times] : seen) {
    const auto [px, py, s] = place;
    ASSERT_EQ(times, 1);
    ASSERT_TRUE(px >= tile.x0 && py >= tile.y0);
    ASSERT_TRUE(s >= tile.first_sample && s < tile.first_sample + per_pixel);
  }
}

TEST_P(Camera, PacketsCoverATileOnceInEveryShape) {
  for (Word w = 0; w <= log2_lanes; ++w) {
    for (Word h = 0; w + h <= log2_lanes; ++h) {
      AeroTile tile = tile_of(3, 7, 24, 20, w, h, log2_lanes - w - h);
      tile.first_sample = 4;
      expect_every_sample_once(tile);
      expect_every_sample_once(tile_of(0, 0, 16, 16, w, h, log2_lanes - w - h));
      expect_every_sample_once(tile_of(5, 5, 6, 6, w, h, log2_lanes - w - h));
    }
  }
}

struct Rays {
  std::vector<float> origin, direction, t_max;
};

Rays rays_of(const Probe& probe, const AeroLaunch& launch) {
  const std::size_t count = std::size_t{launch.tile.block_count} * Word(probe.lanes());
  const auto origin = output<float>(3 * count), direction = output<float>(3 * count);
  const auto t_max = output<float>(count);
  probe.run("probe_rays", count, launch, origin, direction, t_max);
  return {origin.read(), direction.read(), t_max.read()};
}

void expect_near(const vec3& actual, const vec3& expected) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(actual[axis], expected[axis], 4e-7f);
}

TEST_P(Camera, OneSampleLooksThroughThePixelsCentre) {
  // The image has 5 x 3 pixels, and the middle one looks straight ahead.
  AeroLaunch launch{frame_of(5, 3, 1), tile_of(2, 1, 3, 2, log2_lanes, 0, 0), {}};
  launch.frame.camera.corner[1] = 0.6f;
  const Rays rays = rays_of(probe, launch);
  expect_near(from_planes(rays.direction, 0), {0, 0, -1});
  expect_near(from_planes(rays.origin, 0), {1, 2, 3});
  EXPECT_EQ(rays.t_max[0], kInfinity);
}

TEST_P(Camera, CornerPixelsLookAtTheCorners) {
  const Word width = 64, height = 32;
  const AeroLaunch launch{
      frame_of(width, height, 1), tile_of(0, 0, width, height, log2_lanes, 0, 0), {}};
  const Rays rays = rays_of(probe, launch);
  const std::size_t count = std::size_t{width} * height;
  const auto x_of = output<Word>(count), y_of = output<Word>(count), sample = output<Word>(count);
  const auto active = output<int>(count);
  probe.run("probe_packets", count, launch.tile, x_of, y_of, sample, active);
  const auto xs = x_of.read(), ys = y_of.read();
  const auto at = [&](Word x, Word y) {
    std::size_t i = 0;
    while (i + 1 < count && (xs[i] != x || ys[i] != y)) ++i;
    return from_planes(rays.direction, i);
  };
  const float edge = 1.0f - 1.0f / 64.0f, top = 0.5f - 1.0f / 64.0f;
  expect_near(at(0, 0), glm::normalize(vec3(-edge, top, -1)));
  expect_near(at(63, 0), glm::normalize(vec3(edge, top, -1)));
  expect_near(at(0, 31), glm::normalize(vec3(-edge, -top, -1)));
  expect_near(at(63, 31), glm::normalize(vec3(edge, -top, -1)));
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_NEAR(glm::length(dvec3(from_planes(rays.direction, i))), 1.0, 3e-7) << i;
  }
}

TEST_P(Camera, LanesOutsideTheTileAreOff) {
  const AeroLaunch launch{frame_of(64, 32, 1), tile_of(0, 0, 1, 1, log2_lanes, 0, 0), {}};
  const Rays rays = rays_of(probe, launch);
  EXPECT_EQ(rays.t_max[0], kInfinity);
  for (std::size_t i = 1; i < rays.t_max.size(); ++i) EXPECT_LT(rays.t_max[i], 0.0f);
}

struct Drawn {
  std::vector<float> uv, offset;
};

Drawn draw(const Probe& probe, const AeroFrame& frame, const std::vector<Word>& samples) {
  const auto uv = output<float>(2 * samples.size()), offset = output<float>(2 * samples.size());
  probe.run("probe_samples", samples.size(), frame, input(samples), uv, offset);
  return {uv.read(), offset.read()};
}

std::vector<Word> counted(std::size_t count) {
  std::vector<Word> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

struct Moments {
  double mean = 0.0, deviation = 0.0, farthest = 0.0;
};

Moments moments(const float* values, std::size_t count) {
  Moments m;
  double squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    m.mean += static_cast<double>(values[i]) / static_cast<double>(count);
    squares += static_cast<double>(values[i]) * static_cast<double>(values[i]);
    m.farthest = std::max(m.farthest, std::abs(static_cast<double>(values[i])));
  }
  m.deviation = std::sqrt(squares / static_cast<double>(count) - m.mean * m.mean);
  return m;
}

TEST_P(Camera, SamplesFillTheSquareOfTheirPixel) {
  const std::size_t count = 16384;
  const Drawn drawn = draw(probe, frame_of(64, 64, count), counted(count));
  for (int axis = 0; axis < 2; ++axis) {
    const Moments m = moments(drawn.offset.data() + (axis == 0 ? 0 : count), count);
    EXPECT_NEAR(m.mean, 0.0, 0.001) << "axis " << axis;
    EXPECT_NEAR(m.deviation, std::sqrt(1.0 / 12.0), 0.001) << "axis " << axis;
    EXPECT_LE(m.farthest, 0.5) << "axis " << axis;
    EXPECT_GT(m.farthest, 0.499) << "axis " << axis;
  }
}

// Tests that a pixel and a sample may stand in any lane of any packet.
TEST_P(Camera, SamplesDoNotDependOnTheLane) {
  const std::size_t count = 1024;
  std::vector<Word> place = counted(count), shuffled(count);
  std::mt19937 random(9);
  std::shuffle(place.begin(), place.end(), random);
  for (Word i = 0; i < count; ++i) shuffled[place[i]] = i;
  const AeroFrame frame = frame_of(64, 64, count);
  const Drawn straight = draw(probe, frame, counted(count)), mixed = draw(probe, frame, shuffled);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(straight.uv[i], mixed.uv[place[i]]);
    ASSERT_EQ(straight.uv[count + i], mixed.uv[count + place[i]]);
    ASSERT_EQ(straight.offset[i], mixed.offset[place[i]]);
  }
}

TEST_P(Camera, SamplesFillTheSquareEvenly) {
  const std::size_t count = 64;
  AeroFrame frame = frame_of(64, 64, count);
  const Drawn first = draw(probe, frame, counted(count));
  std::set<int> columns, cells;
  for (std::size_t i = 0; i < count; ++i) {
    const float u = first.uv[i], v = first.uv[count + i];
    ASSERT_TRUE(u > 0.0f && u < 1.0f && v > 0.0f && v < 1.0f) << i;
    columns.insert(static_cast<int>(u * 64.0f));
    cells.insert(static_cast<int>(u * 8.0f) * 8 + static_cast<int>(v * 8.0f));
  }
  EXPECT_EQ(columns.size(), count) << "each stratum once";
  // 64 independent samples would leave 23 of the 64 cells empty.
  EXPECT_GE(cells.size(), 50u);
  frame.sample_shift = 0x9abcdef0u;
  EXPECT_NE(draw(probe, frame, counted(count)).uv, first.uv) << "seeds differ";
}

AEROSTAT_AT_EVERY_WIDTH(Camera);

}  // namespace
}  // namespace aerostat::test
