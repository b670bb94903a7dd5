// Tests that the device's noise is the host's, and that its filter drops detail that a pixel cannot
// resolve.
#include "terrain/noise.hpp"

#include <algorithm>
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
        // Gradients are known to 4e-6, and slopes weigh differences of four of them.
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

/// Returns the sum of `octaves` of the host's noise on the turned lattices that the kernel
/// documents.
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
    // Lattice coordinates of up to 70 are rounded to 4e-6. The curvature of the slopes magnifies
    // that.
    const vec3 actual = from_planes(noise, i);
    ASSERT_NEAR(actual.x, expected.x, 1e-4);
    ASSERT_NEAR(actual.y, expected.y, 3e-4);
    ASSERT_NEAR(actual.z, expected.z, 3e-4);
  }
}

TEST_P(NoiseProbe, FractalDropsOctavesThatThePixelCannotResolve) {
  const Points points = random_points(60.0f, 85);
  // Of the wavelengths 8, 4, 2 and 1, a pixel of one metre shows 8 and 4 in full and nothing below.
  EXPECT_EQ(fbm(points, 8.0f, 4, 1.0f), fbm(points, 8.0f, 2, 0.0f));
  for (const float value : fbm(points, 8.0f, 4, 4.0f)) ASSERT_EQ(value, 0.0f);
}

class SolidNoiseProbe : public LaneTest {
 protected:
  struct Field {
    std::vector<float> values, gradients;
  };

  Field sample(const std::vector<vec3>& points, int octaves, bool ridges, float footprint) const {
    const std::size_t count = whole_packets(points.size());
    const auto values = output<float>(count), gradients = output<float>(3 * count);
    const std::vector<float> footprints(count, footprint);
    Probe("noise.cl", GetParam())
        .run("probe_solid", count, 23u, octaves, ridges ? 1 : 0, input(planes(points)),
             input(footprints), values, gradients);
    return {values.read(), gradients.read()};
  }
};

std::vector<vec3> random_space(unsigned seed, float reach) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(-reach, reach);
  std::vector<vec3> points;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const float x = coordinate(random), y = coordinate(random);
    points.push_back({x, y, coordinate(random)});
  }
  return points;
}

TEST_P(SolidNoiseProbe, IsZeroAtLatticePointsAndBounded) {
  std::vector<vec3> points = random_space(86, 200.0f);
  for (std::size_t i = 0; i < kPoints; i += 2) points[i] = glm::floor(points[i]);
  const Field field = sample(points, 0, false, 0.0f);
  float largest = 0.0f;
  for (std::size_t i = 0; i < kPoints; ++i) {
    if (i % 2 == 0) {
      ASSERT_EQ(field.values[i], 0.0f) << i;
    }
    largest = std::max(largest, std::abs(field.values[i]));
  }
  EXPECT_LE(largest, 1.1f);
  EXPECT_GT(largest, 0.4f);
}

// Tests gradients against central differences over a step that sometimes crosses cells.
TEST_P(SolidNoiseProbe, GradientIsTheSlopeOfTheValue) {
  const float step = 1.0f / 128.0f;
  const std::vector<vec3> points = random_space(87, 20.0f);
  for (const int octaves : {0, 3}) {
    const Field field = sample(points, octaves, false, 0.0f);
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<vec3> before = points, after = points;
      for (vec3& p : before) p[axis] -= step;
      for (vec3& p : after) p[axis] += step;
      const Field low = sample(before, octaves, false, 0.0f);
      const Field high = sample(after, octaves, false, 0.0f);
      for (std::size_t i = 0; i < kPoints; ++i) {
        const float slope = (high.values[i] - low.values[i]) / (2.0f * step);
        ASSERT_NEAR(from_planes(field.gradients, i)[axis], slope, 2e-3f) << i << " axis " << axis;
      }
    }
  }
}

TEST_P(SolidNoiseProbe, RidgesFoldEachOctaveAtZero) {
  const std::vector<vec3> points = random_space(88, 50.0f);
  const Field plain = sample(points, 1, false, 0.0f), ridged = sample(points, 1, true, 0.0f);
  for (std::size_t i = 0; i < kPoints; ++i) {
    ASSERT_NEAR(ridged.values[i], 0.5f - 2.0f * std::abs(plain.values[i]), 1e-6f) << i;
    const float side = plain.values[i] < 0.0f ? 2.0f : -2.0f;
    ASSERT_LT(
        glm::distance(from_planes(ridged.gradients, i), side * from_planes(plain.gradients, i)),
        1e-5f)
        << i;
  }
  // A pixel of one metre shows the wavelengths 8 and 4 in full, and nothing below.
  EXPECT_EQ(sample(points, 4, true, 1.0f).values, sample(points, 2, true, 0.0f).values);
}

/// Returns the values of the plane's noise, its fBm, the noise in space and its fBm, one after the
/// other.
std::vector<float> four_values(int lanes, const char* kernel, const std::vector<vec3>& points) {
  const std::size_t count = whole_packets(points.size());
  const auto values = output<float>(4 * count);
  const Probe probe{"noise.cl", lanes};
  probe.run(kernel, count, 23u, 4, input(planes(points)), input(std::vector<float>(count, 0.7f)),
            values);
  return values.read();
}

TEST_P(SolidNoiseProbe, ValuesAloneAreTheSameBits) {
  const std::vector<vec3> points = random_space(89, 300.0f);
  EXPECT_EQ(four_values(GetParam(), "probe_noise_values", points),
            four_values(GetParam(), "probe_noise_with_slopes", points));
}

/// Tests that the other rays of a packet change nothing. Packets within one cell take another path
/// through the code than packets of distant points.
TEST_P(SolidNoiseProbe, NeighboursInAPacketChangeNothing) {
  constexpr std::size_t kNeighbours = 16;
  std::vector<vec3> close = random_space(90, 40.0f);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const vec3 centre = glm::floor(close[i - i % kNeighbours]) + 0.5f;
    close[i] = centre + 0.0122f * close[i];
  }
  std::vector<std::size_t> order(kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    order[i] = (i % (kPoints / kNeighbours)) * kNeighbours + i / (kPoints / kNeighbours);
  }
  std::vector<vec3> apart;
  for (const std::size_t i : order) apart.push_back(close[i]);
  for (const char* kernel : {"probe_noise_values", "probe_noise_with_slopes"}) {
    const auto together = four_values(GetParam(), kernel, close);
    const auto alone = four_values(GetParam(), kernel, apart);
    for (std::size_t value = 0; value < 4 * kPoints; value += kPoints) {
      for (std::size_t i = 0; i < kPoints; ++i) {
        ASSERT_EQ(alone[value + i], together[value + order[i]])
            << kernel << ' ' << value << ' ' << i;
      }
    }
  }
}

AEROSTAT_AT_EVERY_WIDTH(NoiseProbe);
AEROSTAT_AT_EVERY_WIDTH(SolidNoiseProbe);

}  // namespace
}  // namespace aerostat::test
