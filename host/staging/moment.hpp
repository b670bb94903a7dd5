#pragma once

#include <string>

#include "geo/place.hpp"

namespace aerostat::staging {

/// Height of the sun in a morning that is chosen where a scene gives no sun. It was chosen by eye.
inline constexpr double kMorningSun_deg = 21.0;

/// A date and time of the sun, and its azimuth.
struct Moment {
  std::string date, time;
  double azimuth_deg = 0.0;
};

/// Returns the morning in September at which the sun is as high as kMorningSun_deg, or the moment
/// of that day at which it is highest.
Moment morning_at(const geo::Place& place);

/// Returns the date and time of a flight in seconds since 1970, UTC, and where the sun stood. For
/// years for which the sun is not computed, it returns a morning.
Moment moment_of(double time_s, const geo::Place& place);

/// Returns the month of a date such as "2024-09-12", with the share of the month that is over. The
/// date may stand in quotation marks and has been checked.
double month_of(const std::string& date);

}  // namespace aerostat::staging
