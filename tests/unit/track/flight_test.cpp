#include "track/flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support.hpp"
#include "track/clean.hpp"
#include "track/smooth.hpp"
#include "track/summary.hpp"

namespace aerostat::track {
namespace {

const Ground kFlat = [](const geo::Place&) { return 500.0; };

/// Returns how far the flight lies from the truth of a plan, at a time after its start.
double error_at(const Flight& flight, const Plan& plan, double t) {
  const double flown_s = std::clamp(t - plan.stand_s, 0.0, plan.fly_s);
  const double true_m = 501.0 + plan.climb_mps * std::min(flown_s, plan.fly_s - flown_s);
  return flight.at(kPlanStart_s + t).height_m - true_m;
}

struct FitRow {
  const char* name;
  Plan plan;
  HeightReference reference;
  bool has_gnss, has_pressure;
  HeightSource source;
  double most_error_m;
};

using enum HeightReference;

const FitRow kFitRows[] = {
    {"GNSS is right", {}, unknown, true, true, HeightSource::gnss, 1.0},
    {"GNSS is off by 25 m at one end",
     {.gnss_drift_m = 25.0},
     sea,
     true,
     true,
     HeightSource::gnss,
     25.0},
    {"GNSS is off by 10 m", {.gnss_off_m = 10.0}, unknown, true, true, HeightSource::gnss, 10.5},
    {"over the ellipsoid, 48 m",
     {.gnss_off_m = 48.0},
     unknown,
     true,
     true,
     HeightSource::gnss_shifted,
     1.0},
    {"over the ellipsoid, called sea",
     {.gnss_off_m = 48.0},
     sea,
     true,
     true,
     HeightSource::gnss_shifted,
     1.0},
    {"over the ellipsoid, India",
     {.gnss_off_m = -90.0},
     unknown,
     true,
     true,
     HeightSource::gnss_shifted,
     1.0},
    {"ellipsoid by the file, 12 m",
     {.gnss_off_m = 12.0},
     ellipsoid,
     true,
     true,
     HeightSource::gnss_shifted,
     1.0},
    {"GNSS drifts by 80 m",
     {.gnss_drift_m = 80.0},
     unknown,
     true,
     true,
     HeightSource::pressure_fitted,
     1.0},
    {"GNSS is off by 300 m",
     {.gnss_off_m = 300.0},
     unknown,
     true,
     true,
     HeightSource::pressure_fitted,
     1.0},
    {"GNSS drifts, no pressure",
     {.gnss_drift_m = 80.0},
     unknown,
     true,
     false,
     HeightSource::gnss_fitted,
     6.0},
    {"pressure only", {}, unknown, false, true, HeightSource::pressure_fitted, 1.0},
    {"pressure, begun in the air",
     {.stand_s = 0.0, .pressure_off_m = 0.0},
     unknown,
     false,
     true,
     HeightSource::pressure,
     2.0},
    {"GNSS, begun in the air", {.stand_s = 0.0}, unknown, true, true, HeightSource::gnss, 2.0},
};

TEST(Fit, ChoosesTheHeightsThatFitTheGround) {
  for (const FitRow& row : kFitRows) {
    SCOPED_TRACE(row.name);
    Track track = planned(row.plan);
    track.reference = row.reference;
    for (Fix& fix : track.segments[0]) {
      if (!row.has_gnss) fix.gnss_m.reset();
      if (!row.has_pressure) fix.pressure_m.reset();
    }
    const Flight flight = fit_heights(clean(track).track, kFlat);
    EXPECT_EQ(flight.fit().source, row.source);
    EXPECT_TRUE(flight.fit().has_ground);
    const double whole_s = 2.0 * row.plan.stand_s + row.plan.fly_s;
    for (double t = 0.0; t <= whole_s; t += 7.3) {
      // The smoothing rounds the moments at which the climb changes.
      const double round_m = 5.0;
      EXPECT_LE(std::abs(error_at(flight, row.plan, t)), row.most_error_m + round_m) << t;
    }
    EXPECT_LE(std::abs(error_at(flight, row.plan, row.plan.stand_s + 150.0)), row.most_error_m);
  }
}

TEST(Fit, ReportsTheOffsetsAtBothEnds) {
  const Flight flight = fit_heights(planned({.gnss_off_m = 8.0, .gnss_drift_m = 10.0}), kFlat);
  const FitReport& fit = flight.fit();
  EXPECT_TRUE(fit.rests_at_start && fit.rests_at_end);
  EXPECT_NEAR(*fit.gnss.start_m, 10.0, 1.5);
  EXPECT_NEAR(*fit.gnss.end_m, 18.0, 1.5);
  EXPECT_NEAR(*fit.pressure.start_m, -149.0, 0.1);
  EXPECT_EQ(fit.shift_start_m, 0.0);
  EXPECT_EQ(fit.smoothing_s, 20.0);
}

TEST(Fit, TakesHeightsAsTheyAreWithoutAGround) {
  Track track = planned({.gnss_off_m = 48.0});
  const Flight flight = fit_heights(track, {});
  EXPECT_EQ(flight.fit().source, HeightSource::gnss);
  EXPECT_FALSE(flight.fit().has_ground);
  EXPECT_FALSE(flight.fit().gnss.start_m);
  EXPECT_FALSE(flight.at_share(0.5).ground_m);
  track.reference = HeightReference::ellipsoid;
  const Flight ellipsoid = fit_heights(track, {});
  ASSERT_EQ(ellipsoid.fit().notes.size(), 1u);
  EXPECT_TRUE(says(ellipsoid.fit().notes[0], "over the ellipsoid"));
}

TEST(Fit, AddsTheGroundToHeightsOverIt) {
  Track track = planned({});
  track.reference = HeightReference::ground;
  for (Fix& fix : track.segments[0]) fix.gnss_m = 120.0;
  const Ground slope = [](const geo::Place& place) {
    return 500.0 + 1000.0 * (place.longitude_deg - 9.0);
  };
  const Flight flight = fit_heights(track, slope);
  EXPECT_EQ(flight.fit().source, HeightSource::over_ground);
  const Position middle = flight.at_share(0.5);
  EXPECT_NEAR(middle.height_m, *middle.ground_m + 120.0, 0.5);
  EXPECT_EQ(fit_heights(track, {}).fit().source, HeightSource::none);
}

TEST(Fit, AssumesAHeightWhereTheFileHasNone) {
  Track track = planned({});
  for (Fix& fix : track.segments[0]) fix.gnss_m.reset(), fix.pressure_m.reset();
  const Flight flight = fit_heights(track, kFlat);
  EXPECT_EQ(flight.fit().source, HeightSource::assumed);
  EXPECT_NEAR(flight.at_share(0.3).height_m, 650.0, 1e-6);
  EXPECT_EQ(fit_heights(track, {}).fit().source, HeightSource::none);
}

TEST(Fit, FillsHeightsThatAreMissingHereAndThere) {
  Track track = planned({});
  for (std::size_t i = 200; i < 250; ++i) track.segments[0][i].gnss_m.reset();
  track.segments[0].front().gnss_m.reset();
  track.segments[0].back().gnss_m.reset();
  const Flight flight = fit_heights(track, kFlat);
  EXPECT_EQ(flight.fit().filled, 52u);
  EXPECT_NEAR(error_at(flight, {}, 225.0), 0.0, 0.5);
}

TEST(Fit, NeverPiercesTheGroundAndSaysHowOften) {
  // A ridge that reaches 900 m where the flight is at 801 m and lower.
  const Ground ridge = [](const geo::Place& place) {
    const double metres = (place.longitude_deg - 9.0) / kEast_deg_per_m;
    return 500.0 + std::max(0.0, 400.0 - std::abs(metres - 800.0));
  };
  FitOptions options;
  options.clearance_m = 2.0;
  const Flight flight = fit_heights(planned({}), ridge, options);
  EXPECT_GT(flight.fit().clamped, 20u);
  EXPECT_NEAR(flight.fit().clamped_most_m, 80.0, 5.0);
  bool was_clamped = false;
  for (double share = 0.0; share <= 1.0; share += 0.0007) {
    const Position position = flight.at_share(share);
    EXPECT_GE(position.height_m, *position.ground_m + 2.0 - 1e-9);
    was_clamped = was_clamped || position.is_clamped;
  }
  EXPECT_TRUE(was_clamped);
}

TEST(Fit, SaysThatTheTrackLiesOutsideOfTheGround) {
  const Ground nowhere = [](const geo::Place&) { return std::optional<double>(); };
  const Flight flight = fit_heights(planned({}), nowhere);
  EXPECT_FALSE(flight.fit().has_ground);
  ASSERT_FALSE(flight.fit().notes.empty());
  EXPECT_TRUE(says(flight.fit().notes[0], "outside of the ground"));
}

TEST(Flight, TakesOneFix) {
  Track track = planned({});
  track.segments[0].resize(1);
  const Flight flight = fit_heights(clean(track).track, kFlat);
  EXPECT_EQ(flight.at_share(0.7).place, track.segments[0][0].place);
  EXPECT_EQ(summary_of(flight).way_m, 0.0);
  EXPECT_FALSE(summary_of(flight).fastest_mps);
}

TEST(Flight, IsInterpolatedByTime) {
  const Flight flight = fit_heights(planned({.interval_s = 5.0}), kFlat);
  const Position position = flight.at(kPlanStart_s + 272.5);
  EXPECT_NEAR(position.place.longitude_deg, 9.0 + 5.0 * 152.5 * kEast_deg_per_m, 1e-7);
  EXPECT_NEAR(position.height_m, 501.0 + 2.0 * 152.5, 0.1);
  EXPECT_EQ(position.time_s, kPlanStart_s + 272.5);
  EXPECT_EQ(position.ground_m, 500.0);
}

TEST(Flight, RefusesTimesOutsideInWords) {
  Plan plan;
  plan.stand_s = 600.0;
  Track track = clean(planned(plan)).track;
  const Flight flight = fit_heights(track, kFlat);
  // What was cut counts as recorded.
  EXPECT_NEAR(flight.at(kPlanStart_s + 1.0).place.longitude_deg, 9.0, 1e-9);
  EXPECT_EQ(flight.at(kPlanStart_s + 1.0).time_s, kPlanStart_s + 1.0);
  for (const double time_s : {kPlanStart_s - 2.0, kPlanStart_s + 1802.0, std::nan("")}) {
    try {
      flight.at(time_s);
      ADD_FAILURE() << time_s;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_TRUE(
          says(error.what(), "goes from 2023-10-02 07:45:10 UTC to 2023-10-02 08:15:10 UTC"));
    }
  }
  EXPECT_THROW(flight.at_share(std::nan("")), Error);
  EXPECT_EQ(flight.at_share(-1.0).place, flight.at_share(0.0).place);
  EXPECT_EQ(flight.at_share(2.0).place, flight.at_share(1.0).place);
}

TEST(Flight, GoesByTheWayIfThereAreNoTimes) {
  Track track = planned({});
  track.clock = Clock::none;
  for (Fix& fix : track.segments[0]) fix.time_s.reset();
  const Flight flight = fit_heights(clean(track).track, kFlat);
  const Position position = flight.at_share(0.5);
  EXPECT_NEAR(position.place.longitude_deg, 9.0 + 1500.0 * kEast_deg_per_m, 1e-5);
  EXPECT_FALSE(position.time_s);
  EXPECT_THROW(flight.at(kPlanStart_s), Error);
  EXPECT_NEAR(summary_of(flight).way_m, 3000.0, 5.0);
  EXPECT_FALSE(summary_of(flight).fastest_mps);
}

TEST(Flight, HasNoDateIfTheFileHasNone) {
  Track track = planned({});
  track.clock = Clock::of_day;
  for (Fix& fix : track.segments[0]) *fix.time_s -= 1696204800.0;
  const Flight flight = fit_heights(track, kFlat);
  EXPECT_FALSE(flight.at_share(0.5).time_s);
  EXPECT_THROW(flight.at(kPlanStart_s), Error);
  EXPECT_EQ(summary_of(flight).duration_s, 600.0);
}

TEST(Flight, IsNotTheDriveThere) {
  // Ten minutes by car, a minute of rest, the flight, and half an hour back.
  Track track;
  track.clock = Clock::utc;
  track.segments.emplace_back();
  double east_m = 0.0;
  for (int i = 0; i < 3120; ++i) {
    const bool is_drive = i < 600 || i >= 1320;
    const int flown = std::clamp(i - 660, 0, 600);
    east_m += is_drive ? 15.0 : flown > 0 && flown < 600 ? 5.0 : 0.0;
    Fix fix;
    fix.place = {46.0, 9.0 + east_m * kEast_deg_per_m};
    fix.gnss_m = 505.0 + 2.0 * std::min(flown, 600 - flown) + (i % 3);
    fix.time_s = kPlanStart_s + i;
    track.segments[0].push_back(fix);
  }
  const Flight flight = fit_heights(track, kFlat);
  EXPECT_NEAR(flight.course().times[flight.takeoff()], kPlanStart_s + 660.0, 12.0);
  EXPECT_NEAR(flight.course().times[flight.landing()], kPlanStart_s + 1260.0, 12.0);
  EXPECT_NEAR(flight.at_share(0.5).height_m, 1100.0, 12.0);
  EXPECT_NEAR(summary_of(flight).duration_s, 600.0, 24.0);
  // Without a ground nothing tells the drive from the flight.
  EXPECT_EQ(fit_heights(track, {}).takeoff(), 0u);
}

TEST(Flight, NamesItsGaps) {
  Track track = planned({});
  Segment& fixes = track.segments[0];
  Segment second(fixes.begin() + 600, fixes.end());
  fixes.erase(fixes.begin() + 580, fixes.end());
  fixes.erase(fixes.begin() + 300, fixes.begin() + 400);
  track.segments.push_back(second);
  const Flight flight = fit_heights(track, kFlat);
  ASSERT_EQ(flight.gaps().size(), 2u);
  EXPECT_EQ(flight.gaps()[0].from_s, kPlanStart_s + 299.0);
  EXPECT_EQ(flight.gaps()[0].to_s, kPlanStart_s + 400.0);
  EXPECT_NEAR(flight.gaps()[0].way_m, 505.0, 2.0);
  EXPECT_TRUE(flight.at(kPlanStart_s + 350.0).is_in_gap);
  EXPECT_FALSE(flight.at(kPlanStart_s + 250.0).is_in_gap);
  EXPECT_NEAR(error_at(flight, {}, 350.0), 0.0, 2.0);
  const Flight slow = fit_heights(planned({.interval_s = 60.0}), kFlat);
  EXPECT_TRUE(slow.gaps().empty());
}

TEST(Flight, CrossesTheLineOf180Degrees) {
  Track track = planned({});
  for (Fix& fix : track.segments[0]) {
    const double longitude = fix.place.longitude_deg + 170.98;
    fix.place.longitude_deg = longitude > 180.0 ? longitude - 360.0 : longitude;
  }
  const Flight flight = fit_heights(track, kFlat);
  const Summary summary = summary_of(flight);
  EXPECT_NEAR(summary.way_m, 3000.0, 5.0);
  EXPECT_NEAR(summary.extent.west_deg, 179.98, 1e-6);
  EXPECT_GT(summary.extent.east_deg, 180.0);
  EXPECT_NEAR(summary.extent.width_m, 3000.0, 5.0);
  EXPECT_LT(flight.at_share(1.0).place.longitude_deg, 0.0);
}

TEST(Flight, IsSummedUp) {
  const Summary summary = summary_of(fit_heights(planned({}), kFlat));
  EXPECT_NEAR(*summary.takeoff.time_s, kPlanStart_s + 120.0, 3.0);
  EXPECT_NEAR(*summary.landing.time_s, kPlanStart_s + 720.0, 3.0);
  EXPECT_NEAR(summary.duration_s, 600.0, 5.0);
  EXPECT_NEAR(summary.way_m, 3000.0, 10.0);
  EXPECT_NEAR(summary.straight_m, 3000.0, 10.0);
  EXPECT_NEAR(*summary.highest_m, 1101.0, 7.0);  // the smoothing rounds the top
  EXPECT_NEAR(*summary.highest_over_ground_m, 601.0, 7.0);
  EXPECT_NEAR(*summary.fastest_climb_mps, 2.0, 0.01);
  EXPECT_NEAR(*summary.fastest_sink_mps, 2.0, 0.01);
  EXPECT_NEAR(*summary.fastest_mps, 5.0, 0.05);
  EXPECT_EQ(summary.interval_s, 1.0);
}

TEST(Smooth, TakesOutNoiseAndKeepsClimbs) {
  std::vector<double> times, straight, noisy;
  for (int i = 0; i < 100; ++i) {
    times.push_back(i);
    straight.push_back(3.0 * i);
    noisy.push_back(3.0 * i + (i % 2 == 0 ? 6.0 : -6.0));
  }
  const auto kept = smoothed(times, straight, 20.0), quiet = smoothed(times, noisy, 20.0);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(kept[i], straight[i], 1e-9);
    const bool is_at_end = i < 10 || i > 90;
    EXPECT_NEAR(quiet[i], straight[i], is_at_end ? 6.0 : 0.6) << i;
  }
  EXPECT_EQ(smoothed(times, noisy, 0.0), noisy);
}

TEST(Smooth, CurveHasNoKinks) {
  const std::vector<double> times{0, 1, 2, 3}, values{0, 0, 10, 0};
  // The slope of the curve is 0 at a turning point, before it and after it.
  EXPECT_NEAR(value_at(times, values, 1.01), 0.0, 0.01);
  EXPECT_NEAR(value_at(times, values, 1.99), 10.0, 0.01);
  EXPECT_NEAR(value_at(times, values, 2.01), 10.0, 0.01);
}

TEST(Smooth, CurveNeverOvershoots) {
  const std::vector<double> times{0, 1, 2, 50, 51, 52, 53}, values{0, 0, 10, 10, -5, -5, 3};
  double last = -1.0;
  for (double t = -1.0; t < 54.0; t += 0.01) {
    const double value = value_at(times, values, t);
    EXPECT_GE(value, t < 50.0 ? last - 1e-9 : -5.0) << t;
    EXPECT_LE(value, 10.0) << t;
    last = value;
  }
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_EQ(value_at(times, values, times[i]), values[i]);
}

}  // namespace
}  // namespace aerostat::track
