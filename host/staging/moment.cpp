#include "staging/moment.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "scene/sun_angles.hpp"
#include "scene/sun_position.hpp"
#include "staging/flight_point.hpp"

namespace aerostat::staging {
namespace {

constexpr const char* kUsualDate = "2024-09-12";  // chosen by eye

}  // namespace

Moment morning_at(const geo::Place& place) {
  Moment best{kUsualDate, "12:00Z", 180.0};
  double least = 1e9;
  for (int minute = 0; minute < 1440; minute += 5) {
    const std::string time = fmt::format("{:02}:{:02}Z", minute / 60, minute % 60);
    const auto days = scene::detail::days_from_2000(kUsualDate, time);
    const auto sun =
        scene::detail::sun_angles_at(days.value(), place.latitude_deg, place.longitude_deg);
    // In the afternoon the sun is in the west on both hemispheres.
    const bool morning = std::remainder(sun.azimuth_deg, 360.0) > 0.0;
    const double off = std::abs(sun.elevation_deg - kMorningSun_deg) + (morning ? 0.0 : 1000.0);
    if (off >= least) continue;
    least = off;
    best = {kUsualDate, time, sun.azimuth_deg};
  }
  return best;
}

Moment moment_of(double time_s, const geo::Place& place) {
  auto [date, time] = date_and_time(time_s);
  const auto days = scene::detail::days_from_2000(date, time);
  if (!days) return morning_at(place);  // a year for which the sun is not computed
  const auto sun = scene::detail::sun_angles_at(*days, place.latitude_deg, place.longitude_deg);
  return {std::move(date), std::move(time), sun.azimuth_deg};
}

double month_of(const std::string& date) {
  const std::size_t year = date.find("-");
  const auto two_digits = [&date](std::size_t at) {
    return 10.0 * (date[at] - '0') + (date[at + 1] - '0');
  };
  return two_digits(year + 1) + (two_digits(year + 4) - 1.0) / 31.0;
}

}  // namespace aerostat::staging
