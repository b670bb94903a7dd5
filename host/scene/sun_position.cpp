#include "scene/sun_position.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <string_view>
#include <system_error>

#include "scene/celestial.hpp"

namespace aerostat::scene::detail {

namespace {

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
    if (take(time, '.')) {
      const auto thousandths = take_number(time, 3);
      if (!thousandths) return std::nullopt;
      seconds += 0.001 * *thousandths;
    }
  }
  if (time.empty() || time == "Z") return seconds / 86400.0;
  const double sign = time[0] == '+' ? -1.0 : 1.0;
  if (!take(time, '+') && !take(time, '-')) return std::nullopt;
  const auto offset = take_minutes(time);
  if (!offset || !time.empty()) return std::nullopt;
  return (seconds + sign * 60.0 * *offset) / 86400.0;
}

/// Returns the apparent place of the sun. `t` is in Julian centuries from 2000.
Equatorial apparent_place(double t) {
  const double mean_longitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
  const double anomaly = (357.52911 + t * (35999.05029 - t * 0.0001537)) * kDegree;
  const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * std::sin(anomaly) +
                        (0.019993 - t * 0.000101) * std::sin(2.0 * anomaly) +
                        0.000289 * std::sin(3.0 * anomaly);
  const Nutation nutation = nutation_at(t);
  constexpr double kAberration = 0.00569;
  return equatorial_of(mean_longitude + centre - kAberration + nutation.longitude_deg, 0.0,
                       nutation.obliquity_deg);
}

}  // namespace

std::optional<double> days_from_2000(const std::string& date, const std::string& time) {
  const auto days = days_of(date);
  const auto share = day_share_of(time);
  if (!days || !share) return std::nullopt;
  return *days - 0.5 + *share;
}

SunAngles sun_angles_at(double days_from_2000, double latitude_deg, double longitude_deg) {
  const Equatorial sun = apparent_place(orbit_centuries(days_from_2000));
  return lifted_angles(
      seen_from(sun, sidereal_deg_at(days_from_2000) + longitude_deg, latitude_deg));
}

}  // namespace aerostat::scene::detail
