// Tests that the balloons of a festival keep apart in a film.
#include "film/traffic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/log.hpp"
#include "film/course.hpp"
#include "film/timeline.hpp"
#include "scene/balloons.hpp"
#include "scene/scene.hpp"

namespace aerostat::film {
namespace {

TEST(Traffic, KnowsTheLeastDistanceOfWays) {
  Traffic traffic(10.0);
  const auto rest = traffic.way_of([](double) { return dvec3(0.0, 5.0, 0.0); });
  EXPECT_EQ(traffic.least_distance(rest), std::numeric_limits<double>::infinity());
  traffic.add(rest);
  traffic.add(traffic.way_of([](double) { return dvec3(0.0, 905.0, 0.0); }));
  // It passes at 3 m after 6 s.
  const auto passing =
      traffic.way_of([](double time_s) { return dvec3(20.0 * (time_s - 6.0), 5.0, 3.0); });
  EXPECT_NEAR(traffic.least_distance(passing), 3.0, 1e-6);
  // At the end of the film it is at 10 m.
  EXPECT_NEAR(traffic.least_distance(
                  traffic.way_of([](double time_s) { return dvec3(0, 25.0 - time_s, 0); })),
              10.0, 1e-6);
}

/// A festival whose balloons cross each other's ways, because the wind turns with the height.
scene::SceneSource crowd(int seed, const std::string& film) {
  return scene::SceneSource::from_text(
      R"({"version": 1, "biome": "sand", "terrain": {"cells": 32},
          "vegetation": {"enabled": false}, "balloon": {"position": [0, 80, 0]},
          "festival": {"count": 16, "spread_m": [130, 130], "lowest_m": 20, "highest_m": 160,
                       "seed": )" +
          std::to_string(seed) + R"(},
          "film": {"duration_s": 40, "fps": 10, "climb_m_s": 4, "wind": [
              {"height_m": 0, "speed_m_s": 3, "from_deg": 270},
              {"height_m": 120, "speed_m_s": 7, "from_deg": 150},
              {"height_m": 250, "speed_m_s": 9, "from_deg": 30}])" +
          film + "}}",
      "crowd.json");
}

/// Returns the least distance of any two balloons at a time.
double least_at(Timeline& timeline, double time_s) {
  scene::Scene scene = timeline.scene_at_time(time_s);
  const auto all = scene::all_balloons(scene);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      least = std::min(least, glm::distance(all[i]->position, all[k]->position));
    }
  }
  return least;
}

TEST(Traffic, BalloonsOfAFestivalNeverMeet) {
  terrain::ReliefCache reliefs;
  for (const char* film : {"", R"(, "launch_s": 25)"}) {
    for (int seed = 1; seed <= 5; ++seed) {
      Timeline timeline(crowd(seed, film), reliefs);
      double least = std::numeric_limits<double>::infinity();
      for (double time_s = 0.0; time_s <= 40.0; time_s += 0.17) {
        least = std::min(least, least_at(timeline, time_s));
      }
      // Distances are compared every 0.1 s, in which two balloons near each other by some 2 m at
      // most.
      EXPECT_GT(least, scene::Festival().apart_m - 1.0) << film << " seed " << seed;
    }
  }
}

TEST(Traffic, AFestivalWithoutRoomIsTold) {
  terrain::ReliefCache reliefs;
  std::vector<std::string> told;
  const LogSink before = set_log_sink([&](const std::string& message) { told.push_back(message); });
  const Timeline roomy(crowd(1, "").with({{"/festival/count", "5"}}), reliefs);
  EXPECT_TRUE(told.empty()) << told.front();
  const auto steep = crowd(1, "").with({{"/festival/count", "30"}, {"/festival/apart_m", "60"}});
  const Timeline crowded(steep, reliefs);
  set_log_sink(before);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told.front().find("no free course was found for"), std::string::npos) << told.front();
}

TEST(Traffic, ABalloonThatMeetsNobodyKeepsItsCourse) {
  const scene::Festival festival;
  scene::Film film;
  Courses flying(festival, film, 3, 70.0);
  EXPECT_EQ(flying.next().rise_m, 0.0);
  film.launch_s = 20.0;
  Courses launched(festival, film, 3, 70.0);
  const Course first = launched.next();
  ASSERT_TRUE(first.launch.has_value());
  EXPECT_EQ(first.launch->time_s, launch_time(festival.seed, 3, 20.0));
  EXPECT_EQ(first.launch->height_m, 70.0);
  for (int attempt = 1; attempt < Courses::kMost; ++attempt) {
    const Course course = launched.next();
    EXPECT_LT(course.launch->time_s, 20.0);
    EXPECT_GE(course.launch->height_m, festival.lowest_m);
    EXPECT_LE(course.launch->height_m, festival.highest_m);
  }
}

TEST(Traffic, BalloonsRiseSoftlyAndNoFasterThanTheyMay) {
  for (const double rise_m : {60.0, -45.0}) {
    const Course course{std::nullopt, rise_m};
    EXPECT_EQ(course.risen(0.0, 2.5), 0.0);
    EXPECT_EQ(course.risen(1000.0, 2.5), rise_m);
    double fastest = 0.0;
    for (double time_s = 0.0; time_s < 60.0; time_s += 0.1) {
      const double step = course.risen(time_s + 0.1, 2.5) - course.risen(time_s, 2.5);
      fastest = std::max(fastest, std::abs(step) / 0.1);
    }
    EXPECT_LE(fastest, 2.5 + 1e-9);
    EXPECT_GT(fastest, 2.3);
  }
  EXPECT_EQ(Course().risen(5.0, 2.5), 0.0);
}

}  // namespace
}  // namespace aerostat::film
