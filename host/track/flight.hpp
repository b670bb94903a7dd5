#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geo/place.hpp"
#include "track/track.hpp"

namespace aerostat::track {

/// Returns the height of the ground over the sea in metres at a place, if it is known.
using Ground = std::function<std::optional<double>(const geo::Place&)>;

/// Which heights of the file a flight has, and what was done to them.
enum class HeightSource {
  gnss,             // GNSS heights (or ele, altitude), as they are
  gnss_shifted,     // GNSS heights over the ellipsoid, shifted to heights over the sea
  gnss_fitted,      // GNSS heights, shifted so that both ends lie on the ground
  pressure,         // pressure heights, as they are
  pressure_fitted,  // pressure heights, shifted so that both ends lie on the ground
  over_ground,      // the file gives heights over the ground
  assumed,          // the file gives no heights; a fixed height over the ground
  none,             // nothing is known
};

/// How far heights of the file lie over the ground where the logger lay on it.
struct EndOffsets {
  std::optional<double> start_m, end_m;
};

/// How the heights of a flight came about.
struct FitReport {
  HeightSource source = HeightSource::none;
  bool has_ground = false;      // the ground was known at both ends
  bool rests_at_start = false;  // the logger lay still, so it can be tested by the ground
  bool rests_at_end = false;
  EndOffsets gnss, pressure;       // as read, at the first and the last place
  double shift_start_m = 0.0;      // what was added to the heights at the start
  double shift_end_m = 0.0;        // and at the end
  std::size_t filled = 0;          // heights that were missing and were interpolated
  std::size_t clamped = 0;         // fixes that lay lower than the clearance over the ground
  double clamped_most_m = 0.0;     // how far the lowest of them was lifted
  double smoothing_s = 0.0;        // the window over which heights were smoothed
  std::vector<std::string> notes;  // sentences
};

/// Where a flight is at a moment.
struct Position {
  geo::Place place;
  double height_m = 0.0;           // over the sea
  std::optional<double> ground_m;  // the ground below, over the sea
  std::optional<double> time_s;    // UTC, seconds since 1970, if the track has a date
  bool is_in_gap = false;          // the logger recorded nothing there, see Gap
  bool is_clamped = false;         // it was lifted to the clearance over the ground
};

/// A time for which nothing was recorded.
struct Gap {
  double from_s = 0.0, to_s = 0.0;  // in the flight's time
  double way_m = 0.0;               // between the fixes on both sides
};

/// The points of a flight. Its time is that of the track or, if that has none, the way in metres.
struct Course {
  std::vector<double> times;  // rise strictly
  std::vector<double> latitudes_deg;
  std::vector<double> longitudes_deg;  // without jumps at 180 degrees
  std::vector<double> heights_m;       // over the sea; empty if nothing is known
};

/// A way through the air, by time. It keeps its own copy of the function of the ground, which must
/// stay callable as long as the flight is used.
class Flight {
 public:
  Flight(Course course, Clock clock, const Ground& ground, double clearance_m);

  /// Returns the position at a time in seconds since 1970-01-01 00:00 UTC. Up to `cut_start_s`
  /// before the first fix and `cut_end_s` behind the last one it is the place there. Throws
  /// Error{usage} with the times that are possible if the time is outside of them, or if the track
  /// has no times or no date.
  Position at(double time_s) const;

  /// Returns the position at a share of the time, 0 at the take-off and 1 at the landing, or of the
  /// way if the track has no times. Shares beyond are taken for 0 and 1. Throws Error{usage} if
  /// `share` is not a number.
  Position at_share(double share) const;

  /// Returns the position at a point of the course.
  Position position_of(std::size_t point) const { return position(course_.times[point]); }
  /// Returns the height of the ground below a point of the course, if it is known.
  std::optional<double> ground_below(std::size_t point) const;

  Clock clock() const { return clock_; }
  const Course& course() const { return course_; }
  double start() const { return course_.times.front(); }
  double end() const { return course_.times.back(); }
  /// Returns the times for which nothing was recorded for more than 30 s, or between segments.
  const std::vector<Gap>& gaps() const { return gaps_; }
  /// Returns the points of the course at which the flight leaves the ground and comes back to it.
  /// If the ground does not tell, they are where the logger no longer stands still and stands
  /// again.
  std::size_t takeoff() const { return takeoff_; }
  std::size_t landing() const { return landing_; }
  const FitReport& fit() const { return fit_; }

 private:
  friend class Fitting;

  Position position(double time) const;

  Course course_;
  Clock clock_;
  Ground ground_;
  double clearance_m_ = 0.0;
  double cut_start_s_ = 0.0, cut_end_s_ = 0.0;
  std::size_t takeoff_ = 0, landing_ = 0;
  std::vector<Gap> gaps_;
  FitReport fit_;
};

struct FitOptions {
  double smoothing_s = 20.0;        // of heights, 10 to 30 s for receivers of loggers
  double smoothing_place_s = 6.0;   // of places
  double clearance_m = 1.0;         // a flight never comes nearer to the ground
  double height_without_m = 150.0;  // over the ground if the file gives no heights
};

/// Makes a flight of a cleaned track. Its heights are those over the sea that fit the ground best:
/// GNSS heights, tested where the logger lay on the ground before take-off and after landing. If
/// both ends are off by the same 20 to 110 m, they are heights over the ellipsoid and are shifted
/// by that. If they are off otherwise, pressure heights are shifted so that both ends lie on the
/// ground. Without a ground (an empty function) the heights are taken as they are. Throws
/// Error{bad_data} if the track has no fix.
Flight fit_heights(const Track& track, const Ground& ground, const FitOptions& options = {});

}  // namespace aerostat::track
