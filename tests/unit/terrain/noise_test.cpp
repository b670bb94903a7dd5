#include "terrain/noise.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace aerostat::terrain {
namespace {

// The expected values were computed from the definitions in noise.hpp without the code.
TEST(LatticeHash, HasTheDocumentedValues) {
  EXPECT_EQ(lattice_hash(0u, 0, 0), 0x00000000u);
  EXPECT_EQ(lattice_hash(1u, 0, 0), 0xEB40FAD2u);
  EXPECT_EQ(lattice_hash(1u, 2, 3), 0x8EC10005u);
  EXPECT_EQ(lattice_hash(1u, -1, -1), 0xBD8CAC6Cu);
  EXPECT_EQ(lattice_hash(7u, -2147483647 - 1, 2147483647), 0xD78BF682u);
  EXPECT_EQ(lattice_hash(4294967295u, 12345, -6789), 0x72322642u);
}

TEST(LatticeHash, EveryInputBitFlipsHalfOfTheAngleBits) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(-5000, 5000);
  constexpr int kTrials = 4000;
  for (int bit = 0; bit < 31; ++bit) {
    int flips = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const std::uint32_t seed = static_cast<std::uint32_t>(random());
      const int x = place(random);
      const int y = place(random);
      const std::uint32_t other = trial % 2 == 0 ? lattice_hash(seed, x ^ (1 << bit), y)
                                                 : lattice_hash(seed, x, y ^ (1 << bit));
      flips += std::popcount((lattice_hash(seed, x, y) ^ other) >> (32 - kAngleBits));
    }
    EXPECT_NEAR(static_cast<double>(flips) / (kTrials * kAngleBits), 0.5, 0.02) << "bit " << bit;
  }
}

TEST(Perlin, HasTheHandComputedValues) {
  struct Case {
    double x, y;
    std::uint32_t seed;
    double value;
  };
  const Case cases[] = {{0.5, 0.5, 1u, 0.036226992857983},
                        {0.25, 0.75, 1u, -0.000216611778789},
                        {-3.2, 7.9, 5u, 0.014912245594339},
                        {1234.125, -987.0625, 42u, 0.109755468867618},
                        {0.1, 0.0, 0u, 0.102319906410265}};
  for (const Case& c : cases) EXPECT_NEAR(perlin(c.x, c.y, c.seed), c.value, 1e-12);
}

TEST(Perlin, CentreOfACellIsTheMeanOfItsCorners) {
  double expected = 0.0;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const double t = 2.0 * std::numbers::pi * (lattice_hash(9u, 4 + i, -3 + j) >> 20) / 4096.0;
      expected += 0.25 * (std::cos(t) * (0.5 - i) + std::sin(t) * (0.5 - j));
    }
  EXPECT_NEAR(perlin(4.5, -2.5, 9u), expected, 1e-14);
}

TEST(Perlin, IsExactlyZeroAtLatticePoints) {
  for (int y = -20; y <= 20; ++y)
    for (int x = -20; x <= 20; ++x) EXPECT_EQ(perlin(x, y, 3u), 0.0);
  EXPECT_EQ(perlin(2147483000.0, -2147483000.0, 3u), 0.0);
}

TEST(Perlin, SlopeAtALatticePointIsItsUnitGradient) {
  const NoiseSample n = perlin_with_slope(6.0, -2.0, 8u);
  const double t = 2.0 * std::numbers::pi * (lattice_hash(8u, 6, -2) >> 20) / 4096.0;
  EXPECT_NEAR(n.dx, std::cos(t), 1e-14);
  EXPECT_NEAR(n.dy, std::sin(t), 1e-14);
}

TEST(Perlin, ValueAndSlopeAreContinuousAcrossCells) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-50.0, 50.0);
  for (int trial = 0; trial < 2000; ++trial) {
    const double along = place(random);
    const double edge = std::floor(place(random));
    const double e = 1e-9;
    const bool vertical = trial % 2 == 0;
    const auto at = [&](double across) {
      return vertical ? perlin_with_slope(across, along, 2u) : perlin_with_slope(along, across, 2u);
    };
    const NoiseSample before = at(edge - e);
    const NoiseSample after = at(edge + e);
    EXPECT_NEAR(before.value, after.value, 1e-7);
    EXPECT_NEAR(before.dx, after.dx, 1e-6);
    EXPECT_NEAR(before.dy, after.dy, 1e-6);
  }
}

TEST(Perlin, DerivativesMatchFiniteDifferences) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> place(-300.0, 300.0);
  for (int trial = 0; trial < 5000; ++trial) {
    const double x = place(random);
    const double y = place(random);
    const double e = 1e-5;
    const NoiseSample n = perlin_with_slope(x, y, 4u);
    EXPECT_EQ(n.value, perlin(x, y, 4u));
    EXPECT_NEAR(n.dx, (perlin(x + e, y, 4u) - perlin(x - e, y, 4u)) / (2 * e), 1e-7);
    EXPECT_NEAR(n.dy, (perlin(x, y + e, 4u) - perlin(x, y - e, 4u)) / (2 * e), 1e-7);
  }
}

TEST(Perlin, StaysInItsRangeAndUsesIt) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> place(-5000.0, 5000.0);
  double lowest = 0.0;
  double highest = 0.0;
  double sum = 0.0;
  constexpr int kTrials = 400000;
  for (int trial = 0; trial < kTrials; ++trial) {
    const double n = perlin(place(random), place(random), 21u);
    lowest = std::min(lowest, n);
    highest = std::max(highest, n);
    sum += n;
  }
  EXPECT_LE(highest, kNoiseBound);
  EXPECT_GE(lowest, -kNoiseBound);
  EXPECT_GT(highest, 0.6);
  EXPECT_LT(lowest, -0.6);
  EXPECT_NEAR(sum / kTrials, 0.0, 2e-3);
}

TEST(Perlin, DependsOnTheSeed) {
  double product = 0.0;
  double square = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double x = 0.377 * i;
    const double y = 0.219 * i;
    product += perlin(x, y, 1u) * perlin(x, y, 2u);
    square += perlin(x, y, 1u) * perlin(x, y, 1u);
  }
  EXPECT_LT(std::fabs(product / square), 0.05);
}

TEST(Perlin, HasNoPreferredDirection) {
  std::mt19937 random(19);
  std::uniform_real_distribution<double> place(-4000.0, 4000.0);
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (int trial = 0; trial < 200000; ++trial) {
    const NoiseSample n = perlin_with_slope(place(random), place(random), 23u);
    xx += n.dx * n.dx;
    yy += n.dy * n.dy;
    xy += n.dx * n.dy;
  }
  EXPECT_NEAR(xx / yy, 1.0, 0.02);
  EXPECT_NEAR(xy / xx, 0.0, 0.02);
}

TEST(NoiseLayer, BlocksMatchThePointFunction) {
  const NoiseLayer layer = make_layer(250.0, 77u, 3u);
  std::mt19937 random(29);
  std::uniform_real_distribution<float> place(-4000.0f, 4000.0f);
  Points points;
  points.count = kBlockSize;
  for (int i = 0; i < points.count; ++i) {
    points.x[i] = place(random);
    points.z[i] = place(random);
    points.spacing[i] = 0.0f;
  }
  Block value, again, dx, dz;
  sample(layer, points, value);
  sample(layer, points, again, dx, dz);
  for (int i = 0; i < points.count; ++i) {
    const double u = double{layer.along_x} * points.x[i] - double{layer.along_z} * points.z[i];
    const double v = double{layer.along_z} * points.x[i] + double{layer.along_x} * points.z[i];
    const NoiseSample n = perlin_with_slope(u + layer.offset_x, v + layer.offset_y, layer.seed);
    EXPECT_EQ(value[i], again[i]);
    EXPECT_NEAR(value[i], n.value, 1e-4);
    EXPECT_NEAR(dx[i], n.dx * layer.along_x + n.dy * layer.along_z, 1e-5);
    EXPECT_NEAR(dz[i], n.dy * layer.along_x - n.dx * layer.along_z, 1e-5);
  }
}

/// Tests coordinates at which single precision has no values between lattice points, and beyond the
/// range of an integer.
TEST(Noise, IsANumberHoweverFarAway) {
  for (const double wavelength : {1e-3, 1e-6, 3.6e-12}) {
    const NoiseLayer layer = make_layer(wavelength, 5u, 2u);
    Points points;
    for (const float x : {0.0f, 0.3f, -7e3f, 5e4f, -1e6f, 3e6f}) {
      for (const float z : {0.0f, 1e4f, -2e6f}) {
        for (int copy = 0; copy < 2; ++copy) {
          points.x[points.count] = x;
          points.z[points.count] = z;
          points.spacing[points.count++] = 0.0f;
        }
      }
    }
    Block value, dx, dz, alone;
    sample(layer, points, value, dx, dz);
    sample(layer, points, alone);
    for (int i = 0; i < points.count; ++i) {
      ASSERT_LE(std::fabs(value[i]), 0.7072f) << points.x[i] << ' ' << points.z[i];
      ASSERT_EQ(alone[i], value[i]);
      ASSERT_TRUE(std::isfinite(dx[i]) && std::isfinite(dz[i]));
    }
  }
  for (const double far : {1e9, 1e12, 1e300}) {
    ASSERT_LE(std::abs(perlin(far, -far, 3u)), kNoiseBound);
    ASSERT_LE(std::abs(perlin_with_slope(-far, far, 3u).value), kNoiseBound);
  }
}

}  // namespace
}  // namespace aerostat::terrain
