// The device's noise is the host's, and its filter drops what a pixel cannot resolve.
#include "terrain/noise.hpp"

#include <cmath>
#include <random>

#include "probe.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kPoints = 4096;

struct Points {
  std::vector<float> x, y;
};

Points random_points(float reach, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(-reach, reach);
  Points points;
  for (std::size_t i = 0; i < kPoints; ++i) {
    points.x.push_back(coordinate(random));
    points.y.push_back(coordinate(random));
  }
  return points;
}

class NoiseProbe : public LaneTest {
 protected:
  const Probe probe{"noise.cl", GetParam()};

  std::vector<float> perlin(const Points& points, std::uint32_t seed) const {
    const auto noise = output<float>(3 * points.x.size());
    probe.run("probe_perlin", points.x.size(), seed, input(points.x), input(points.y), noise);
    return noise.read();
  }

  std::vector<float> fbm(const Points& points, float wavelength, int octaves,
                         float footprint) const {
    const auto noise = output<float>(3 * points.x.size());
    const std::vector<float> footprints(points.x.size(), footprint);
    probe.run("probe_fbm", points.x.size(), 17u, wavelength, octaves, 0.6f, input(points.x),
              input(points.y), input(footprints), noise);
    return noise.read();
  }
};

TEST_P(NoiseProbe, IsTheHostsNoise) {
  for (const float reach : {3.0f, 300.0f, 8000.0f}) {
    for (const std::uint32_t seed : {0u, 1u, 4000000000u}) {
      const Points points = random_points(reach, 81);
      const auto noise = perlin(points, seed);
      for (std::size_t i = 0; i < kPoints; ++i) {
        const auto expected = terrain::perlin_with_slope(static_cast<double>(points.x[i]),
                                                         static_cast<double>(points.y[i]), seed);
        const vec3 actual = from_planes(noise, i);
        // Gradients are known to 4e-6; slopes weigh differences of four of them.
        ASSERT_NEAR(actual.x, expected.value, 1e-5) << points.x[i] << ", " << points.y[i];
        ASSERT_NEAR(actual.y, expected.dx, 3e-5);
        ASSERT_NEAR(actual.z, expected.dy, 3e-5);
      }
    }
  }
}

TEST_P(NoiseProbe, IsZeroAtLatticePoints) {
  Points points = random_points(2000.0f, 82);
  for (std::size_t i = 0; i < kPoints; ++i) {
    points.x[i] = std::floor(points.x[i]);
    points.y[i] = std::floor(points.y[i]);
  }
  const auto noise = perlin(points, 3u);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const vec3 n = from_planes(noise, i);
    ASSERT_EQ(n.x, 0.0f);
    ASSERT_NEAR(std::hypot(n.y, n.z), 1.0f, 1e-5f) << "a unit gradient";
  }
}

TEST_P(NoiseProbe, KeepsItsBound) {
  const auto noise = perlin(random_points(500.0f, 83), 5u);
  float largest = 0.0f;
  for (std::size_t i = 0; i < kPoints; ++i) largest = std::max(largest, std::abs(noise[i]));
  EXPECT_LE(static_cast<double>(largest), terrain::kNoiseBound + 1e-5);
  EXPECT_GT(largest, 0.4f);
}

TEST_P(NoiseProbe, WavesAreResolvedAboveFourFootprintsAndGoneBelowTwo) {
  const float wavelength = 8.0f;
  const std::vector<float> footprints =
      padded({0.0f, 1e-6f, 1.0f, 2.0f, 2.5f, 3.0f, 4.0f, 9.0f, 1e9f});
  const auto share = output<float>(footprints.size());
  probe.run("probe_resolved", footprints.size(), wavelength, input(footprints), share);
  const auto shares = share.read();
  for (const std::size_t i : {0, 1, 2, 3}) EXPECT_EQ(shares[i], 1.0f) << footprints[i];
  EXPECT_NEAR(shares[4], 0.6f, 1e-6f);
  EXPECT_NEAR(shares[5], 1.0f / 3.0f, 1e-6f);
  for (const std::size_t i : {6, 7, 8}) EXPECT_EQ(shares[i], 0.0f) << footprints[i];
}

/// The sum of `octaves` of the host's noise on the turned lattices that the kernel documents.
dvec3 summed_octaves(double x, double z, double wavelength, int octaves) {
  dvec3 sum(0.0);
  double along = 1.0 / wavelength, across = 0.0, amplitude = 1.0;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(octaves); ++i) {
    const auto n =
        terrain::perlin_with_slope(along * x - across * z, across * x + along * z, 17u + i);
    sum += amplitude * dvec3(n.value, n.dx * along + n.dy * across, n.dy * along - n.dx * across);
    const double turned = 2.0 * (0.8 * along - 0.6 * across);
    across = 2.0 * (0.6 * along + 0.8 * across);
    along = turned;
    amplitude *= 0.6;
  }
  return sum;
}

TEST_P(NoiseProbe, FractalWithoutAFootprintIsTheSumOfItsOctaves) {
  const Points points = random_points(60.0f, 84);
  const auto noise = fbm(points, 7.0f, 4, 0.0f);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const dvec3 expected =
        summed_octaves(static_cast<double>(points.x[i]), static_cast<double>(points.y[i]), 7.0, 4);
    // Lattice coordinates of up to 70 are rounded to 4e-6, the slopes' curvature magnifies that.
    const vec3 actual = from_planes(noise, i);
    ASSERT_NEAR(actual.x, expected.x, 1e-4);
    ASSERT_NEAR(actual.y, expected.y, 3e-4);
    ASSERT_NEAR(actual.z, expected.z, 3e-4);
  }
}

TEST_P(NoiseProbe, FractalDropsOctavesThatThePixelCannotResolve) {
  const Points points = random_points(60.0f, 85);
  // Of wavelengths 8, 4, 2 and 1, a pixel of one metre sees 8 and 4 in full and nothing below.
  EXPECT_EQ(fbm(points, 8.0f, 4, 1.0f), fbm(points, 8.0f, 2, 0.0f));
  for (const float value : fbm(points, 8.0f, 4, 4.0f)) ASSERT_EQ(value, 0.0f);
}

AEROSTAT_AT_EVERY_WIDTH(NoiseProbe);

}  // namespace
}  // namespace aerostat::test
