#include "land/height_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace aerostat::land {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

TEST(StepOf, FindsWholeMetresFeetAndDecimetres) {
  EXPECT_EQ(step_of({12.0f, kNone, -3.0f, 1834.0f}, 1.0f), 1.0f);
  EXPECT_FLOAT_EQ(step_of({0.3048f, 304.8f, 1000.0f * 0.3048f}, 0.3048f), 0.3048f);
  EXPECT_FLOAT_EQ(step_of({1.3f, 17.2f, -0.1f}, 1.0f), 0.1f);
  EXPECT_EQ(step_of({1.234f, 5.678f}, 1.0f), 0.0f);
}

TEST(SmoothSteps, TurnTerracesIntoASlopeWithinHalfAStep) {
  constexpr int kWidth = 200, kHeight = 40;
  std::vector<float> rounded;
  for (int j = 0; j < kHeight; ++j)
    for (int i = 0; i < kWidth; ++i) rounded.push_back(std::round(0.1f * static_cast<float>(i)));
  std::vector<float> smooth = rounded;
  smooth_steps(kWidth, kHeight, 1.0f, smooth);
  float steepest_before = 0.0f, steepest = 0.0f, worst = 0.0f;
  for (int i = 30; i < kWidth - 30; ++i) {
    const int at = 20 * kWidth + i;
    steepest_before = std::max(steepest_before, rounded[at + 1] - rounded[at]);
    steepest = std::max(steepest, smooth[at + 1] - smooth[at]);
    worst = std::max(worst, std::abs(smooth[at] - 0.1f * static_cast<float>(i)));
  }
  EXPECT_EQ(steepest_before, 1.0f);
  EXPECT_LT(steepest, 0.2f);  // the slope itself is 0.1
  EXPECT_LT(worst, 0.2f);
  for (std::size_t k = 0; k < smooth.size(); ++k) {
    EXPECT_LE(std::abs(smooth[k] - rounded[k]), 0.5f);
  }
}

TEST(SmoothSteps, LeaveALakeFlat) {
  std::vector<float> lake(64 * 64, 433.0f);
  smooth_steps(64, 64, 1.0f, lake);
  EXPECT_TRUE(std::all_of(lake.begin(), lake.end(), [](float h) { return h == 433.0f; }));
}

}  // namespace
}  // namespace aerostat::land
