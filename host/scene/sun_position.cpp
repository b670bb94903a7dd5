#include "scene/sun_position.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string_view>
#include <system_error>

namespace aerostat::scene::detail {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kDaysPerCentury = 36525.0;
// Universal time lags behind the time used for orbits, by 64 to 69 s between 2000 and 2025.
constexpr double kClockLagDays = 67.0 / 86400.0;

/// Reads `count` digits off the front of `text`. Returns nothing if there are fewer.
std::optional<int> take_number(std::string_view& text, std::size_t count) {
  int value = 0;
  const char* const end = text.data() + std::min(count, text.size());
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (text.size() < count || error != std::errc() || stop != end || text[0] == '-') {
    return std::nullopt;
  }
  text.remove_prefix(count);
  return value;
}

bool take(std::string_view& text, char sign) {
  if (text.empty() || text[0] != sign) return false;
  text.remove_prefix(1);
  return true;
}

/// Returns the whole days from 1 January 2000 to a date.
std::optional<int> days_of(std::string_view date) {
  const auto year = take_number(date, 4);
  if (!year || !take(date, '-')) return std::nullopt;
  const auto month = take_number(date, 2);
  if (!month || !take(date, '-')) return std::nullopt;
  const auto day = take_number(date, 2);
  if (!day || !date.empty()) return std::nullopt;
  const std::chrono::year_month_day given{std::chrono::year(*year),
                                          std::chrono::month(static_cast<unsigned>(*month)),
                                          std::chrono::day(static_cast<unsigned>(*day))};
  if (!given.ok() || *year < 1900 || *year > 2100) return std::nullopt;
  using namespace std::chrono_literals;
  return static_cast<int>(
      (std::chrono::sys_days(given) - std::chrono::sys_days(2000y / 1 / 1)).count());
}

/// Reads hours and minutes, written hh:mm, off the front of `text`. Returns them in minutes.
std::optional<int> take_minutes(std::string_view& text) {
  const auto hours = take_number(text, 2);
  if (!hours || !take(text, ':')) return std::nullopt;
  const auto minutes = take_number(text, 2);
  if (!minutes || *hours > 23 || *minutes > 59) return std::nullopt;
  return 60 * *hours + *minutes;
}

/// Returns the days from midnight, in universal time, to a time of day.
std::optional<double> day_share_of(std::string_view time) {
  const auto clock = take_minutes(time);
  if (!clock) return std::nullopt;
  double seconds = 60.0 * *clock;
  if (take(time, ':')) {
    const auto extra = take_number(time, 2);
    if (!extra || *extra > 59) return std::nullopt;
    seconds += *extra;
  }
  if (time.empty() || time == "Z") return seconds / 86400.0;
  const double sign = time[0] == '+' ? -1.0 : 1.0;
  if (!take(time, '+') && !take(time, '-')) return std::nullopt;
  const auto offset = take_minutes(time);
  if (!offset || !time.empty()) return std::nullopt;
  return (seconds + sign * 60.0 * *offset) / 86400.0;
}

struct Equatorial {
  double right_ascension;
  double declination;
};

/// Returns the apparent place of the sun in radians. `t` is in Julian centuries from 2000.
Equatorial apparent_place(double t) {
  const double mean_longitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
  const double anomaly = (357.52911 + t * (35999.05029 - t * 0.0001537)) * kDegree;
  const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * std::sin(anomaly) +
                        (0.019993 - t * 0.000101) * std::sin(2.0 * anomaly) +
                        0.000289 * std::sin(3.0 * anomaly);
  const double node = (125.04 - 1934.136 * t) * kDegree;
  // The last two terms are the aberration and the nutation of the longitude.
  const double longitude = (mean_longitude + centre - 0.00569 - 0.00478 * std::sin(node)) * kDegree;
  const double obliquity =
      (23.0 + (26.0 + 21.448 / 60.0) / 60.0 -
       t * (46.8150 + t * (0.00059 - t * 0.001813)) / 3600.0 + 0.00256 * std::cos(node)) *
      kDegree;
  return {std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude)),
          std::asin(std::sin(obliquity) * std::sin(longitude))};
}

/// Returns the angle by which the air lifts a light at a true elevation, both in degrees. Returns
/// 0 below -1 degree.
double refraction_deg(double elevation_deg) {
  if (elevation_deg < -1.0) return 0.0;
  return 1.02 / 60.0 / std::tan((elevation_deg + 10.3 / (elevation_deg + 5.11)) * kDegree);
}

}  // namespace

std::optional<double> days_from_2000(const std::string& date, const std::string& time) {
  const auto days = days_of(date);
  const auto share = day_share_of(time);
  if (!days || !share) return std::nullopt;
  return *days - 0.5 + *share;
}

SunAngles sun_angles_at(double days_from_2000, double latitude_deg, double longitude_deg) {
  const Equatorial sun = apparent_place((days_from_2000 + kClockLagDays) / kDaysPerCentury);
  const double centuries = days_from_2000 / kDaysPerCentury;
  const double sidereal_deg = 280.46061837 + 360.98564736629 * days_from_2000 +
                              centuries * centuries * 0.000387933 + longitude_deg;
  const double hour_angle = std::fmod(sidereal_deg, 360.0) * kDegree - sun.right_ascension;
  const double latitude = latitude_deg * kDegree;
  const double east = -std::cos(sun.declination) * std::sin(hour_angle);
  const double north = std::sin(sun.declination) * std::cos(latitude) -
                       std::cos(sun.declination) * std::cos(hour_angle) * std::sin(latitude);
  const double up = std::sin(sun.declination) * std::sin(latitude) +
                    std::cos(sun.declination) * std::cos(hour_angle) * std::cos(latitude);
  const double elevation_deg = std::atan2(up, std::hypot(east, north)) / kDegree;
  return {std::atan2(east, north) / kDegree, elevation_deg + refraction_deg(elevation_deg)};
}

}  // namespace aerostat::scene::detail
