// Tests the wind and what follows a place that moves.
#include "film/wind.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace aerostat::film {
namespace {

using scene::WindLayer;

const std::vector<WindLayer> kLayers{{0.0, 2.0, 270.0}, {1000.0, 10.0, 0.0}};

TEST(Wind, BlowsFromItsAzimuth) {
  const dvec2 low = wind_at(kLayers, -50.0), high = wind_at(kLayers, 5000.0);
  EXPECT_NEAR(glm::distance(low, dvec2(2.0, 0.0)), 0.0, 1e-12);    // from west to east
  EXPECT_NEAR(glm::distance(high, dvec2(0.0, 10.0)), 0.0, 1e-12);  // from north to south
  EXPECT_NEAR(glm::distance(wind_at(kLayers, 250.0), dvec2(1.5, 2.5)), 0.0, 1e-12);
  EXPECT_EQ(wind_at({}, 100.0), dvec2(0.0));
}

TEST(Wind, ClimbingSteers) {
  Drift drift(kLayers, [](double time) { return time < 10.0 ? 0.0 : 1000.0; });
  EXPECT_NEAR(glm::distance(drift.at(10.0), dvec2(20.0, 0.0)), 0.0, 1e-9);
  EXPECT_NEAR(glm::distance(drift.at(13.0), dvec2(20.0, 30.0)), 0.0, 1e-9);
}

TEST(Wind, AWayDependsOnItsTimeAlone) {
  const auto height = [](double time) { return 500.0 + 400.0 * std::sin(time); };
  Drift forth(kLayers, height), back(kLayers, height);
  std::vector<dvec2> ways;
  for (int i = 0; i <= 50; ++i) ways.push_back(forth.at(0.37 * i));
  for (int i = 50; i >= 0; --i) EXPECT_EQ(back.at(0.37 * i), ways[static_cast<std::size_t>(i)]);
}

TEST(Chase, LagsBehindByItsTime) {
  Chase chase([](double time) { return dvec3(3.0 * time, 0.0, 0.0); }, 2.0);
  EXPECT_EQ(chase.at(0.0), dvec3(0.0));
  // After many lags, the follower is two seconds behind, but for the length of a step.
  EXPECT_NEAR(chase.at(40.0).x, 3.0 * (40.0 - 2.0), 0.05);
  Chase without([](double time) { return dvec3(time); }, 0.0);
  EXPECT_EQ(without.at(1.5), dvec3(1.5));
}

TEST(Chase, APlaceDependsOnItsTimeAlone) {
  const auto place = [](double time) { return dvec3(std::cos(time), time, std::sin(time)); };
  Chase forth(place, 0.7), back(place, 0.7);
  const dvec3 late = back.at(9.99), early = back.at(0.333);
  EXPECT_EQ(forth.at(0.333), early);
  EXPECT_EQ(forth.at(9.99), late);
}

}  // namespace
}  // namespace aerostat::film
