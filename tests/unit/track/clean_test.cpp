#include "track/clean.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "support.hpp"
#include "track/distance.hpp"
#include "track/standing.hpp"

namespace aerostat::track {
namespace {

CleanOptions whole() {
  CleanOptions options;
  options.cut_standing = false;
  return options;
}

TEST(TrackDistance, FollowsTheEllipsoid) {
  EXPECT_NEAR(distance_m({0, 0}, {0, 1}), 111319.5, 120.0);
  EXPECT_NEAR(distance_m({46, 9}, {47, 9}), 111161.0, 120.0);
  EXPECT_NEAR(distance_m({46, 179.99}, {46, -179.99}), distance_m({46, 9}, {46, 9.02}), 0.01);
  EXPECT_EQ(unwrapped(-179.0, 179.0), 181.0);
  EXPECT_EQ(wrapped(181.0), -179.0);
  EXPECT_EQ(wrapped(-180.0), 180.0);
}

struct OutlierRow {
  const char* name;
  std::function<void(Segment&)> damage;
  std::size_t outliers;
};

TEST(TrackClean, LeavesOutOutliersAndNothingElse) {
  const auto move = [](Segment& fixes, std::size_t first, std::size_t count, double degrees) {
    for (std::size_t i = first; i < first + count; ++i) fixes[i].place.latitude_deg += degrees;
  };
  const OutlierRow rows[] = {
      {"nothing", [](Segment&) {}, 0},
      {"one fix far off", [&](Segment& f) { move(f, 300, 1, 0.5); }, 1},
      {"three fixes far off", [&](Segment& f) { move(f, 300, 3, 0.5); }, 3},
      {"two places far off",
       [&](Segment& f) {
         move(f, 300, 1, 0.5);
         move(f, 301, 1, -0.5);
       },
       2},
      {"the first fixes", [&](Segment& f) { move(f, 0, 2, 0.5); }, 2},
      {"the last fixes", [&](Segment& f) { move(f, f.size() - 2, 2, 0.5); }, 2},
      {"noise of 20 m",
       [&](Segment& f) {
         for (std::size_t i = 0; i < f.size(); i += 2) move(f, i, 1, 2e-4);
       },
       0},
      {"a jump for good", [&](Segment& f) { move(f, 300, f.size() - 300, 0.5); }, 0},
      {"half a minute elsewhere", [&](Segment& f) { move(f, 300, 30, 0.5); }, 0},
      {"an airliner",
       [&](Segment& f) {
         for (std::size_t i = 0; i < f.size(); ++i) move(f, i, 1, 0.0025 * static_cast<double>(i));
       },
       0},
  };
  for (const OutlierRow& row : rows) {
    Track track = planned({});
    row.damage(track.segments[0]);
    const std::size_t before = track.fix_count();
    const Cleaned cleaned = clean(track, whole());
    EXPECT_EQ(cleaned.report.outliers, row.outliers) << row.name;
    EXPECT_EQ(cleaned.track.fix_count(), before - row.outliers) << row.name;
    EXPECT_EQ(notes_of(cleaned.track).empty(), row.outliers == 0) << row.name;
  }
}

TEST(TrackClean, LeavesOutInvalidFixesAndThoseAtNullIsland) {
  Track track = planned({});
  track.segments[0][5].valid = false;
  track.segments[0][6].place = {0.0, 0.0};
  const Cleaned cleaned = clean(track, whole());
  EXPECT_EQ(cleaned.report.invalid, 1u);
  EXPECT_EQ(cleaned.report.nowhere, 1u);
  EXPECT_TRUE(
      says(notes_of(cleaned.track), "Cleaning left out 1 fix that the file marks as doubtful"));
  EXPECT_TRUE(says(notes_of(cleaned.track), "Cleaning left out 1 fix at 0 N 0 E"));
  for (Fix& fix : track.segments[0]) fix.valid = false;
  EXPECT_THROW(clean(track), Error);
}

TEST(TrackClean, LeavesOutHeightsButKeepsTheirPlaces) {
  Track track = planned({});
  track.segments[0][300].gnss_m = 9999.0;
  track.segments[0][301].pressure_m = -9000.0;
  const Cleaned cleaned = clean(track, whole());
  EXPECT_EQ(cleaned.report.wrong_heights, 2u);
  EXPECT_EQ(cleaned.track.fix_count(), track.fix_count());
  EXPECT_FALSE(cleaned.track.segments[0][300].gnss_m);
  EXPECT_TRUE(cleaned.track.segments[0][300].pressure_m);
}

TEST(TrackClean, KeepsGaps) {
  Track track = planned({});
  Segment& fixes = track.segments[0];
  fixes.erase(fixes.begin() + 300, fixes.begin() + 500);
  EXPECT_EQ(clean(track, whole()).track.fix_count(), fixes.size());
}

TEST(TrackClean, CutsStandingButForAMinute) {
  Plan plan;
  plan.stand_s = 1800.0;
  const Cleaned cleaned = clean(planned(plan));
  EXPECT_NEAR(cleaned.report.cut_start_s, 1740.0, 3.0);
  EXPECT_NEAR(cleaned.report.cut_end_s, 1740.0, 3.0);
  EXPECT_EQ(cleaned.track.cut_start_s, cleaned.report.cut_start_s);
  EXPECT_TRUE(says(notes_of(cleaned.track), "of standing before the start were cut."));
  EXPECT_EQ(clean(planned(plan), whole()).track.cut_start_s, 0.0);
}

struct StandingRow {
  const char* name;
  Plan plan;
  double start_s, end_s;  // how long it stands
  bool rests;
};

TEST(TrackStanding, IsFoundAtBothEnds) {
  const StandingRow rows[] = {
      {"a flight with wind", {.stand_s = 100.0}, 100.0, 100.0, true},
      {"straight up", {.stand_s = 100.0, .east_mps = 0.0}, 100.0, 100.0, true},
      {"slowly along", {.stand_s = 100.0, .east_mps = 1.0, .climb_mps = 0.0}, 100.0, 100.0, true},
      {"begun in the air", {.stand_s = 0.0}, 0.0, 0.0, false},
      {"every ten seconds", {.stand_s = 100.0, .interval_s = 10.0}, 100.0, 100.0, true},
  };
  for (const StandingRow& row : rows) {
    const Track track = planned(row.plan);
    const Standing standing = standing_ends(track.segments[0]);
    const double interval_s = row.plan.interval_s;
    EXPECT_NEAR(static_cast<double>(standing.start) * interval_s, row.start_s, 2.0 * interval_s)
        << row.name;
    EXPECT_NEAR(static_cast<double>(standing.end) * interval_s, row.end_s, 2.0 * interval_s)
        << row.name;
    EXPECT_EQ(standing.rests_at_start, row.rests) << row.name;
    EXPECT_EQ(standing.rests_at_end, row.rests) << row.name;
  }
}

TEST(TrackStanding, BearsAReceiverThatWanders) {
  Track track = planned({});
  Segment& fixes = track.segments[0];
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const double turn = 0.05 * static_cast<double>(i);
    fixes[i].place.latitude_deg += 1.2e-4 * std::sin(turn);  // 13 m
    *fixes[i].gnss_m += 8.0 * std::sin(1.7 * turn);
  }
  fixes[40].place.latitude_deg += 0.001;  // for a moment 110 m away
  const Standing standing = standing_ends(fixes);
  EXPECT_NEAR(static_cast<double>(standing.start), 120.0, 12.0);
}

TEST(TrackStanding, IsNotAWholeTrackThatNeverLeaves) {
  Plan plan;
  plan.east_mps = plan.climb_mps = 0.0;
  const Cleaned cleaned = clean(planned(plan));
  EXPECT_EQ(cleaned.report.cut_start_s, 0.0);
  EXPECT_EQ(cleaned.track.fix_count(), planned(plan).fix_count());
}

TEST(TrackClean, LeavesOutRepeatedPlacesWithoutTimes) {
  Track track = planned({});
  track.clock = Clock::none;
  for (Fix& fix : track.segments[0]) fix.time_s.reset();
  const Cleaned cleaned = clean(track);
  EXPECT_EQ(cleaned.report.duplicates, 240u);
  EXPECT_TRUE(says(notes_of(cleaned.track), "240 fixes at the place of the one before"));
}

}  // namespace
}  // namespace aerostat::track
