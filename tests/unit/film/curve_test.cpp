// Tests the curves that cameras fly along.
#include "film/curve.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace aerostat::film {
namespace {

const std::vector<dvec3> kBends{{0, 0, 0}, {10, 0, 0}, {11, 2, 0}, {11, 2, 40}, {-30, 5, 41}};
const std::vector<double> kTimes{0.0, 1.0, 4.0, 5.0, 9.0};

TEST(Curve, GoesThroughItsPointsAtTheirTimes) {
  const Curve curve(kBends, kTimes, false);
  for (std::size_t i = 0; i < kBends.size(); ++i) {
    EXPECT_NEAR(glm::distance(curve.at(kTimes[i]), kBends[i]), 0.0, 1e-9) << i;
  }
  EXPECT_EQ(curve.at(-1.0), kBends.front());
  EXPECT_EQ(curve.at(99.0), kBends.back());
}

TEST(Curve, AlongALineItNeverGoesBack) {
  const std::vector<dvec3> line{{0, 0, 0}, {1, 0, 0}, {50, 0, 0}, {51, 0, 0}, {400, 0, 0}};
  const Curve curve(line, {0.0, 3.0, 3.1, 8.0, 8.5}, false);
  double last = 0.0;
  for (double time = 0.0; time <= 8.5; time += 0.005) {
    const double x = curve.at(time).x;
    EXPECT_GE(x, last - 1e-9) << time;
    last = x;
  }
}

TEST(Curve, SpeedHasNoJumps) {
  const Curve curve(kBends, kTimes, false);
  // The speed on both sides of a point, over a tenth of a millisecond.
  constexpr double kStep = 1e-4;
  for (std::size_t i = 1; i + 1 < kTimes.size(); ++i) {
    const double t = kTimes[i];
    const dvec3 before = (curve.at(t) - curve.at(t - kStep)) / kStep;
    const dvec3 after = (curve.at(t + kStep) - curve.at(t)) / kStep;
    EXPECT_LT(glm::distance(before, after), 0.05) << i;
  }
}

TEST(Curve, ConstantSpeedIsConstant) {
  const Curve curve(kBends, kTimes, true);
  std::vector<double> speeds;
  constexpr double kStep = 0.01;
  for (double time = 0.0; time + kStep <= 9.0; time += kStep) {
    speeds.push_back(glm::distance(curve.at(time), curve.at(time + kStep)) / kStep);
  }
  const auto [least, most] = std::minmax_element(speeds.begin(), speeds.end());
  // Chords of a sharp bend are shorter than the curve, by 3 % at this step.
  EXPECT_LT(*most / *least, 1.03);
  EXPECT_EQ(curve.at(9.0), kBends.back());
}

TEST(Curve, OnePointRests) {
  const Curve curve({{1, 2, 3}}, {0.0}, true);
  EXPECT_EQ(curve.at(5.0), dvec3(1, 2, 3));
}

}  // namespace
}  // namespace aerostat::film
