// Tests steps of spread values, and what noise does inside of a footprint, against sums over random
// values.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "ground/ground_rule.hpp"
#include "ground/solid_noise.hpp"
#include "scene/scene.hpp"

namespace aerostat::ground {
namespace {

TEST(SpreadStep, IsTheMeanOfStepsOverNormallyDistributedValues) {
  for (const float variance : {0.01f, 0.2f, 5.0f}) {
    for (float x = -4.0f; x <= 5.0f; x += 0.25f) {
      double sum = 0.0, weights = 0.0;
      for (double z = -6.0; z <= 6.0; z += 0.01) {
        const double weight = std::exp(-0.5 * z * z);
        const auto value = static_cast<float>(static_cast<double>(x) +
                                              z * std::sqrt(static_cast<double>(variance)));
        sum += weight * static_cast<double>(rules::smooth_step(0.0f, 1.0f, value));
        weights += weight;
      }
      EXPECT_NEAR(rules::spread_step(0.0f, 1.0f, x, variance), sum / weights, 0.032) << x;
    }
  }
}

TEST(SpreadStep, IsTheStepItselfWhereNothingVaries) {
  for (float x = 1.0f; x <= 5.0f; x += 0.125f) {
    EXPECT_NEAR(rules::spread_step(2.0f, 4.0f, x, 0.0f), rules::smooth_step(2.0f, 4.0f, x), 1e-6f);
  }
}

/// Returns the mean variance of the noise at points of footprints, which are distributed as the
/// rules say.
rules::SolidVariance measured(const rules::SolidFbm& fbm, float footprint) {
  constexpr int kFootprints = 600;
  std::mt19937 random(53);
  std::uniform_real_distribution<float> anywhere(-300.0f, 300.0f);
  std::normal_distribution<float> inside(0.0f, FOOTPRINT_SIGMA * footprint);
  rules::SolidVariance mean{0.0f, 0.0f};
  for (int i = 0; i < kFootprints; ++i) {
    const vec3 centre(anywhere(random), anywhere(random), anywhere(random));
    Spots spots, beside;
    const float step = 1e-3f * fbm.wavelength;
    for (int k = 0; k < kBlockSize; ++k) {
      const vec3 p = centre + vec3(inside(random), 0.0f, inside(random));
      spots.add(p);
      // The slope along a diagonal is the mean over the axes.
      beside.add(p + step * glm::normalize(vec3(1.0f)));
    }
    Block values, next;
    fill_values(fbm, spots, 0.0f, values);
    fill_values(fbm, beside, 0.0f, next);
    const auto variance = [](const auto& of) {
      double sum = 0.0, squares = 0.0;
      for (std::size_t k = 0; k < kBlockSize; ++k) {
        sum += of(k);
        squares += of(k) * of(k);
      }
      return (squares - sum * sum / kBlockSize) / (kBlockSize - 1);
    };
    mean.value += static_cast<float>(
                      variance([&](std::size_t k) { return static_cast<double>(values[k]); })) /
                  kFootprints;
    mean.slope += static_cast<float>(variance([&](std::size_t k) {
                    return static_cast<double>(next[k] - values[k]) / static_cast<double>(step);
                  })) /
                  kFootprints;
  }
  return mean;
}

/// Tests the correlations of one octave. The variance that points of a footprint have around their
/// mean is what two of them differ by, and two points are sqrt(2) times as far apart as a point is
/// from the middle.
TEST(SolidVariance, FollowsFromTheCorrelationOfPointsInsideAFootprint) {
  for (const bool folded : {false, true}) {
    const rules::SolidFbm fbm = rules::solid_fbm_of(7u, 8.0f, 1, 0.5f, folded ? 1 : 0);
    const float whole = folded ? SOLID_NOISE_FOLDED_VARIANCE : SOLID_NOISE_VARIANCE;
    // Folding doubles slopes.
    const float steep = SOLID_NOISE_FOLDED_SLOPE_VARIANCE / 4.0f / (8.0f * 8.0f);
    for (const float footprint : {0.5f, 1.0f, 2.0f, 4.0f}) {
      const rules::SolidVariance truth = measured(fbm, footprint);
      const float apart = std::sqrt(2.0f) * footprint;
      EXPECT_NEAR(truth.value / whole, 1.0f - rules::value_correlation(fbm, apart), 0.03f)
          << footprint << (folded ? " folded" : "");
      // Creases are no part of the correlation of slopes.
      if (folded) continue;
      EXPECT_NEAR(truth.slope / steep, 1.0f - rules::slope_correlation(fbm, apart), 0.05f)
          << footprint;
    }
  }
}

/// Tests that octaves add up, each with its own weight.
TEST(SolidVariance, IsTheSumOverTheOctaves) {
  const rules::SolidFbm fbm = rules::solid_fbm_of(7u, 8.0f, 2, 0.5f, 1);
  const rules::SolidFbm second = rules::solid_fbm_of(8u, 4.0f, 1, 1.0f, 1);
  const rules::SolidFbm first = rules::solid_fbm_of(7u, 8.0f, 1, 1.0f, 1);
  const rules::SolidVariance both = rules::variance_inside(fbm, 0.8f);
  const rules::SolidVariance a = rules::variance_inside(first, 0.8f);
  const rules::SolidVariance b = rules::variance_inside(second, 0.8f);
  EXPECT_FLOAT_EQ(both.value, a.value + 0.25f * b.value);
  EXPECT_FLOAT_EQ(both.slope, a.slope + 0.25f * b.slope);
  EXPECT_EQ(rules::variance_inside(fbm, 0.0f).value, 0.0f);
  EXPECT_EQ(rules::variance_inside(fbm, 5.0f).slope, 0.0f) << "nothing is left of the waves";
}

}  // namespace
}  // namespace aerostat::ground
