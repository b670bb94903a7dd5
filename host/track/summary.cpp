#include "track/summary.hpp"

#include <algorithm>
#include <vector>

#include "track/distance.hpp"
#include "track/standing.hpp"

namespace aerostat::track {

namespace {

constexpr double kRateWindow_s = 10.0;
constexpr double kLongestRateWindow_s = 30.0;  // of slow loggers

geo::Place place_of(const Course& course, std::size_t i) {
  return {course.latitudes_deg[i], wrapped(course.longitudes_deg[i])};
}

Extent extent_of(const Course& course) {
  const auto [south, north] =
      std::minmax_element(course.latitudes_deg.begin(), course.latitudes_deg.end());
  const auto [west, east] =
      std::minmax_element(course.longitudes_deg.begin(), course.longitudes_deg.end());
  const double turn = *west - wrapped(*west);
  Extent extent{*south, *north, *west - turn, *east - turn, 0.0, 0.0};
  const double middle_deg = 0.5 * (*south + *north);
  extent.width_m = distance_m({middle_deg, extent.west_deg}, {middle_deg, extent.east_deg});
  extent.height_m = distance_m({*south, extent.west_deg}, {*north, extent.west_deg});
  return extent;
}

/// Measures the speeds over windows that hold no gap.
void add_rates(const Flight& flight, Summary& summary) {
  const Course& course = flight.course();
  const bool has_heights = !course.heights_m.empty();
  std::size_t first = flight.takeoff();
  double climb = 0.0, sink = 0.0, fastest = 0.0;
  bool is_measured = false;
  for (std::size_t i = first + 1; i <= flight.landing(); ++i) {
    while (first + 1 < i && course.times[i] - course.times[first + 1] >= kRateWindow_s) ++first;
    const double seconds = course.times[i] - course.times[first];
    if (seconds < kRateWindow_s || seconds > kLongestRateWindow_s) continue;
    is_measured = true;
    fastest = std::max(fastest, distance_m(place_of(course, first), place_of(course, i)) / seconds);
    if (!has_heights) continue;
    const double rate = (course.heights_m[i] - course.heights_m[first]) / seconds;
    climb = std::max(climb, rate);
    sink = std::max(sink, -rate);
  }
  if (!is_measured) return;
  summary.fastest_mps = fastest;
  if (!has_heights) return;
  summary.fastest_climb_mps = climb;
  summary.fastest_sink_mps = sink;
}

}  // namespace

Summary summary_of(const Flight& flight) {
  const Course& course = flight.course();
  const std::size_t first = flight.takeoff(), last = flight.landing();
  Summary summary;
  summary.fixes = course.times.size();
  summary.takeoff = flight.position_of(first);
  summary.landing = flight.position_of(last);
  summary.straight_m = distance_m(place_of(course, first), place_of(course, last));
  summary.extent = extent_of(course);
  for (std::size_t i = first + 1; i <= last; ++i) {
    summary.way_m += distance_m(place_of(course, i - 1), place_of(course, i));
  }
  for (std::size_t i = first; i <= last && !course.heights_m.empty(); ++i) {
    const double height_m = course.heights_m[i];
    summary.highest_m = std::max(summary.highest_m.value_or(height_m), height_m);
    summary.lowest_m = std::min(summary.lowest_m.value_or(height_m), height_m);
    if (const auto ground_m = flight.ground_below(i)) {
      const double over_m = height_m - *ground_m;
      summary.highest_over_ground_m =
          std::max(summary.highest_over_ground_m.value_or(over_m), over_m);
    }
  }
  if (flight.clock() == Clock::none) return summary;
  summary.duration_s = course.times[last] - course.times[first];
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < course.times.size(); ++i) {
    steps_s.push_back(course.times[i] - course.times[i - 1]);
  }
  summary.interval_s = median(steps_s);
  add_rates(flight, summary);
  return summary;
}

}  // namespace aerostat::track
