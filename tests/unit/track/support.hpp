#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "track/read.hpp"

/// Helpers of the tests of tracks.
namespace aerostat::track {

/// Returns all notes as one text.
inline std::string notes_of(const Track& track) {
  std::string text;
  for (const std::string& note : track.notes) text += note + "\n";
  return text;
}

inline testing::AssertionResult says(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "'" << part << "' is not in: " << text;
}

/// Returns the message of the error of reading `bytes`, or an empty text if they can be read.
inline std::string complaint(const std::string& bytes, const ReadOptions& options = {}) {
  try {
    read_bytes(bytes, "x", options);
  } catch (const Error& error) {
    const bool is_expected =
        error.kind() == ErrorKind::bad_data || error.kind() == ErrorKind::usage;
    EXPECT_TRUE(is_expected) << error.what();
    return error.what();
  }
  return "";
}

/// How a test track moves: from t = 0 it stands for `stand_s`, flies for `fly_s`, and stands again.
struct Plan {
  double stand_s = 120.0, fly_s = 600.0;
  double east_mps = 5.0;      // while it flies
  double climb_mps = 2.0;     // in the first half, and down again in the second
  double ground_m = 500.0;    // its height while it stands
  double gnss_off_m = 0.0;    // added to GNSS heights
  double gnss_drift_m = 0.0;  // and growing to this at the end
  double pressure_off_m = -150.0;
  double interval_s = 1.0;
};

inline constexpr double kPlanStart_s = 1696232710.0;      // 2023-10-02 07:45:10 UTC
inline constexpr double kEast_deg_per_m = 1.0 / 77469.0;  // at 46 degrees north

inline Track planned(const Plan& plan) {
  Track track;
  track.clock = Clock::utc;
  track.segments.emplace_back();
  const double whole_s = 2.0 * plan.stand_s + plan.fly_s;
  for (double t = 0.0; t <= whole_s; t += plan.interval_s) {
    const double flown_s = std::clamp(t - plan.stand_s, 0.0, plan.fly_s);
    const double up_s = std::min(flown_s, plan.fly_s - flown_s);
    const double height_m = plan.ground_m + plan.climb_mps * up_s;
    Fix fix;
    fix.place = {46.0, 9.0 + plan.east_mps * flown_s * kEast_deg_per_m};
    fix.gnss_m = height_m + 1.0 + plan.gnss_off_m + plan.gnss_drift_m * t / whole_s;
    fix.pressure_m = height_m + 1.0 + plan.pressure_off_m;
    fix.time_s = kPlanStart_s + t;
    track.segments[0].push_back(fix);
  }
  return track;
}

}  // namespace aerostat::track
