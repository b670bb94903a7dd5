#include "track/times.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace aerostat::track {
namespace {

constexpr double kNone = -1.0;

/// Returns a track of one segment with these times after 2023-10-02, in seconds.
Track track_of(const std::vector<double>& times_s, double base_s = 1696204800.0) {
  Track track;
  track.clock = Clock::utc;
  track.segments.emplace_back();
  for (const double time_s : times_s) {
    Fix fix;
    fix.place = {46.0 + 0.001 * static_cast<double>(track.fix_count()), 9.0};
    if (time_s != kNone) fix.time_s = base_s + time_s;
    track.segments[0].push_back(fix);
  }
  return track;
}

struct Row {
  std::vector<double> times_s;
  std::size_t left;
  Clock clock;
  const char* note;
};

TEST(TrackTimes, AreMendedOrGivenUp) {
  const Row rows[] = {
      {{1, 2, 3, 4}, 4, Clock::utc, ""},
      {{1, 2, 900, 3, 4}, 4, Clock::utc, "1 fix was left out because the clock ran backwards"},
      {{1, 2, 0, 3, 4}, 4, Clock::utc, "1 fix was left out because the clock ran backwards"},
      {{1, 2, 2, 2, 3}, 3, Clock::utc, "2 fixes were left out because the one before has the same"},
      {{1, 2, kNone, 4}, 3, Clock::utc, "1 fix was without a time left out"},
      {{1, kNone, kNone, kNone}, 4, Clock::none, "Only 1 of 4 fixes have a time"},
      {{9, 8, 7, 6, 5}, 5, Clock::none, "The times run backwards"},
      {{kNone, kNone}, 2, Clock::none, "has no times"},
      {{1, 2, -2e9, 4}, 3, Clock::utc, "1 time is wrong (such as 1960-05-16"},
      {{1, 2, 9e9, 4}, 3, Clock::utc, "before 1980 or after 2100"},
  };
  for (const Row& row : rows) {
    Track track = track_of(row.times_s);
    settle_times(track, {});
    EXPECT_EQ(track.fix_count(), row.left) << row.note;
    EXPECT_EQ(track.clock, row.clock) << row.note;
    EXPECT_TRUE(says(notes_of(track), row.note));
    double last_s = -1.0;
    for (const Fix& fix : track.segments[0]) {
      ASSERT_EQ(fix.time_s.has_value(), row.clock == Clock::utc) << row.note;
      if (!fix.time_s) continue;
      EXPECT_GT(*fix.time_s, last_s) << row.note;
      last_s = *fix.time_s;
    }
  }
}

TEST(TrackTimes, Of1901AreNotUsed) {
  Track track = track_of({3, 2, 1}, -2147397248.0);
  settle_times(track, {});
  EXPECT_EQ(track.clock, Clock::none);
  EXPECT_EQ(track.fix_count(), 3u);
  EXPECT_TRUE(says(notes_of(track), "The times are wrong (such as 1901-12-14 20:45:53 UTC"));
}

TEST(TrackTimes, TakeTheDateFromTheOptions) {
  Track track = track_of({10, 20}, 0.0);
  track.clock = Clock::of_day;
  ReadOptions options;
  options.start_s = 1696232710.0;
  settle_times(track, options);
  EXPECT_EQ(track.clock, Clock::utc);
  EXPECT_EQ(track.segments[0][0].time_s, 1696204800.0 + 10.0);
}

TEST(TrackTimes, RisingPartIsTheLongest) {
  const std::vector<bool> rises = rising_part({5, 1, 2, 9, 3, 3, 4, 0});
  EXPECT_EQ(rises, (std::vector<bool>{false, true, true, false, true, true, true, false}));
  EXPECT_TRUE(rising_part({}).empty());
}

}  // namespace
}  // namespace aerostat::track
