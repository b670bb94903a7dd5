#include "track/flight.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "track/distance.hpp"
#include "track/smooth.hpp"
#include "track/text.hpp"

namespace aerostat::track {

Flight::Flight(Course course, Clock clock, const Ground& ground, double clearance_m)
    : course_(std::move(course)), clock_(clock), ground_(ground), clearance_m_(clearance_m) {}

Position Flight::position(double time) const {
  const double longitude = value_at(course_.times, course_.longitudes_deg, time);
  Position position;
  position.place = {value_at(course_.times, course_.latitudes_deg, time), wrapped(longitude)};
  if (ground_) position.ground_m = ground_(position.place);
  if (!course_.heights_m.empty()) {
    position.height_m = value_at(course_.times, course_.heights_m, time);
  }
  const double least_m = position.ground_m.value_or(-1e9) + clearance_m_;
  if (position.height_m < least_m) {
    position.height_m = least_m;
    position.is_clamped = true;
  }
  if (clock_ == Clock::utc) position.time_s = time;
  position.is_in_gap = std::any_of(gaps_.begin(), gaps_.end(), [&](const Gap& gap) {
    return time > gap.from_s && time < gap.to_s;
  });
  return position;
}

std::optional<double> Flight::ground_below(std::size_t point) const {
  if (!ground_) return std::nullopt;
  return ground_({course_.latitudes_deg[point], wrapped(course_.longitudes_deg[point])});
}

Position Flight::at(double time_s) const {
  if (clock_ != Clock::utc) {
    throw Error(ErrorKind::usage,
                clock_ == Clock::none
                    ? "the track has no times; give a share of the way from 0 to 1, or the track's "
                      "start and the interval between its fixes"
                    : "the track has no date; give a share of the time from 0 to 1, or the date as "
                      "the track's start");
  }
  const double first_s = start() - cut_start_s_, last_s = end() + cut_end_s_;
  // Users give times in whole seconds, but the times of fixes may have fractions of a second.
  if (!(time_s >= std::floor(first_s) && time_s <= std::ceil(last_s))) {
    throw Error(ErrorKind::usage,
                fmt::format("{} is not within the track, which goes from {} to {}",
                            utc_text(time_s), utc_text(first_s), utc_text(last_s)));
  }
  Position found = position(std::clamp(time_s, start(), end()));
  found.time_s = time_s;
  return found;
}

Position Flight::at_share(double share) const {
  if (std::isnan(share)) throw Error(ErrorKind::usage, "the share of the track is not a number");
  const double first = course_.times[takeoff_], last = course_.times[landing_];
  return position(first + std::clamp(share, 0.0, 1.0) * (last - first));
}

}  // namespace aerostat::track
