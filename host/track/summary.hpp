#pragma once

#include <cstddef>
#include <optional>

#include "track/flight.hpp"

namespace aerostat::track {

/// The rectangle of degrees around a flight. Over 180 degrees `east_deg` is greater than 180.
struct Extent {
  double south_deg = 0.0, north_deg = 0.0, west_deg = 0.0, east_deg = 0.0;
  double width_m = 0.0, height_m = 0.0;  // from west to east in the middle, and from south to north
};

/// The figures of a flight from take-off to landing.
struct Summary {
  std::size_t fixes = 0;  // of the whole course
  Position takeoff, landing;
  double duration_s = 0.0;  // 0 without times
  double way_m = 0.0;       // over the ground
  double straight_m = 0.0;  // from take-off to landing
  Extent extent;            // of the whole course
  double interval_s = 0.0;  // the median from fix to fix

  std::optional<double> highest_m, lowest_m;  // over the sea
  std::optional<double> highest_over_ground_m;
  std::optional<double> fastest_climb_mps, fastest_sink_mps;  // over 10 s; without times none
  std::optional<double> fastest_mps;                          // over the ground, over 10 s
};

Summary summary_of(const Flight& flight);

}  // namespace aerostat::track
