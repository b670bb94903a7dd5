// Tests that points of the sun's disc and directions of the sky are evenly distributed in each
// pixel, in each square of pixels, and in the shapes that they are mapped to.
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>

#include "camera.h"
#include "probe.hpp"

namespace aerostat::test {
namespace {

using Word = std::uint32_t;

constexpr Word kSide = 4;
constexpr float kRadius = 0.05f;

struct Chosen {
  std::vector<Word> pixels;
  std::vector<vec3> uvw, in_disc, by_cosine;
};

class LightSamples : public LaneTest {
 protected:
  /// Returns all samples of a square of 4 x 4 pixels, in packets of several pixels.
  Chosen choose(Word samples, const vec3& axis) const {
    const auto log2_lanes = static_cast<Word>(std::bit_width(static_cast<Word>(GetParam()))) - 1;
    AeroLaunch launch{};
    launch.frame.samples = samples;
    launch.frame.sample_shift = 0x9e3779b9u;
    launch.frame.width = kSide;
    launch.tile = {0, 0, kSide, kSide, 0, 0, 0, log2_lanes - log2_lanes / 2, log2_lanes / 2, 0};
    launch.tile.blocks_per_row = kSide >> launch.tile.log2_w;
    launch.tile.block_count = launch.tile.blocks_per_row * (kSide >> launch.tile.log2_h);
    const std::vector<float> towards{axis.x, axis.y, axis.z};
    const std::size_t count = kSide * kSide;
    Chosen all;
    for (launch.tile.first_sample = 0; launch.tile.first_sample < samples;
         ++launch.tile.first_sample) {
      const auto pixels = output<Word>(count);
      const auto uvw = output<float>(3 * count), disc = output<float>(3 * count);
      const auto cosine = output<float>(3 * count);
      probe_.run("probe_light_samples", count, launch, input(towards), kRadius, pixels, uvw, disc,
                 cosine);
      const auto at = pixels.read();
      all.pixels.insert(all.pixels.end(), at.begin(), at.end());
      append(all.uvw, uvw.read());
      append(all.in_disc, disc.read());
      append(all.by_cosine, cosine.read());
    }
    return all;
  }

 private:
  static void append(std::vector<vec3>& to, const std::vector<float>& values) {
    for (std::size_t i = 0; i < values.size() / 3; ++i) to.push_back(from_planes(values, i));
  }

  const Probe probe_{"sampling.cl", GetParam()};
};

AEROSTAT_AT_EVERY_WIDTH(LightSamples);

/// Returns the largest difference between the share of points below (u, v) and u v. The corners (u,
/// v) are formed by coordinates of the points.
double discrepancy(const std::vector<vec3>& points) {
  double worst = 0.0;
  for (const vec3& a : points) {
    for (const vec3& b : points) {
      double inside = 0.0;
      for (const vec3& p : points) inside += p.x <= a.x && p.y <= b.y ? 1.0 : 0.0;
      worst = std::max(worst, std::abs(inside / static_cast<double>(points.size()) -
                                       static_cast<double>(a.x) * static_cast<double>(b.y)));
    }
  }
  return worst;
}

TEST_P(LightSamples, FillTheUnitCube) {
  for (const vec3& p : choose(16, {0, 1, 0}).uvw) {
    for (int c = 0; c < 3; ++c) {
      ASSERT_GE(p[c], 0.0f);
      ASSERT_LT(p[c], 1.0f);
    }
  }
}

/// Tests the discrepancy of the samples. Random points have a discrepancy of 0.14 (64 points) and
/// 0.25 (16 points) on average.
TEST_P(LightSamples, AreEvenInASquareOfPixelsAndInEachPixel) {
  EXPECT_LT(discrepancy(choose(4, {0, 1, 0}).uvw), 0.06);
  const Chosen many = choose(16, {0, 1, 0});
  std::map<Word, std::vector<vec3>> by_pixel;
  for (std::size_t i = 0; i < many.uvw.size(); ++i) by_pixel[many.pixels[i]].push_back(many.uvw[i]);
  ASSERT_EQ(by_pixel.size(), kSide * kSide);
  double mean = 0.0;
  for (const auto& [pixel, points] : by_pixel) {
    EXPECT_EQ(points.size(), 16u) << "pixel " << pixel;
    mean += discrepancy(points) / static_cast<double>(by_pixel.size());
  }
  EXPECT_LT(mean, 0.19);
}

TEST_P(LightSamples, DifferFromPixelToPixel) {
  std::set<std::pair<float, float>> seen;
  for (const vec3& p : choose(4, {0, 1, 0}).uvw) seen.insert({p.x, p.y});
  EXPECT_EQ(seen.size(), 4u * kSide * kSide);
}

/// Tests the mean and the mean square of the samples. In a disc of radius r they are the centre and
/// r^2 / 2.
TEST_P(LightSamples, SpreadEvenlyOverADisc) {
  for (const vec3 axis : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(0, 1, 0), vec3(0.6f, 0.0f, -0.8f)}) {
    const Chosen chosen = choose(64, axis);
    dvec3 mean(0.0);
    double square = 0.0;
    for (const vec3& d : chosen.in_disc) {
      ASSERT_NEAR(glm::length(d), 1.0f, 1e-6f);
      const dvec3 off = dvec3(d) / glm::dot(dvec3(d), dvec3(axis)) - dvec3(axis);
      ASSERT_LE(glm::length(off), kRadius * 1.0001);
      mean += off;
      square += glm::dot(off, off);
    }
    const auto count = static_cast<double>(chosen.in_disc.size());
    EXPECT_LT(glm::length(mean) / count, 0.01 * kRadius);
    EXPECT_NEAR(square / count, 0.5 * kRadius * kRadius, 0.01 * kRadius * kRadius);
  }
}

/// Tests the distribution by the cosine. Its mean direction is 2/3 of the normal, and the mean of
/// the squared cosine is 1/2.
TEST_P(LightSamples, FollowTheCosineAroundANormal) {
  for (const vec3 normal : {vec3(0, 1, 0), vec3(0, -1, 0), vec3(0.6f, 0.0f, -0.8f)}) {
    const Chosen chosen = choose(64, normal);
    dvec3 mean(0.0);
    double square = 0.0;
    for (const vec3& d : chosen.by_cosine) {
      ASSERT_NEAR(glm::length(d), 1.0f, 1e-5f);
      const double cosine = glm::dot(dvec3(d), dvec3(normal));
      ASSERT_GE(cosine, -1e-6);
      mean += dvec3(d);
      square += cosine * cosine;
    }
    const auto count = static_cast<double>(chosen.by_cosine.size());
    EXPECT_LT(glm::distance(mean / count, dvec3(normal) * (2.0 / 3.0)), 0.01);
    EXPECT_NEAR(square / count, 0.5, 0.01);
  }
}

}  // namespace
}  // namespace aerostat::test
