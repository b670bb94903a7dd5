#include "scene/celestial.hpp"

#include <cmath>

namespace aerostat::scene::detail {

namespace {

constexpr double kClockLagDays = 67.0 / 86400.0;

double refraction_deg(double elevation_deg) {
  if (elevation_deg < -1.0) return 0.0;
  return 1.02 / 60.0 / std::tan((elevation_deg + 10.3 / (elevation_deg + 5.11)) * kDegree);
}

}  // namespace

double orbit_centuries(double days_from_2000) {
  return (days_from_2000 + kClockLagDays) / kDaysPerCentury;
}

Nutation nutation_at(double t) {
  const double node = (125.04 - 1934.136 * t) * kDegree;
  const double mean_obliquity =
      23.0 + (26.0 + 21.448 / 60.0) / 60.0 - t * (46.8150 + t * (0.00059 - t * 0.001813)) / 3600.0;
  return {-0.00478 * std::sin(node), mean_obliquity + 0.00256 * std::cos(node)};
}

Equatorial equatorial_of(double longitude_deg, double latitude_deg, double obliquity_deg) {
  const double longitude = longitude_deg * kDegree, latitude = latitude_deg * kDegree;
  const double tilt = obliquity_deg * kDegree;
  const double x = std::cos(latitude) * std::cos(longitude);
  const double y = std::cos(latitude) * std::sin(longitude);
  const double z = std::sin(latitude);
  return {std::atan2(y * std::cos(tilt) - z * std::sin(tilt), x),
          std::asin(y * std::sin(tilt) + z * std::cos(tilt))};
}

double sidereal_deg_at(double days_from_2000) {
  const double centuries = days_from_2000 / kDaysPerCentury;
  return 280.46061837 + 360.98564736629 * days_from_2000 + centuries * centuries * 0.000387933;
}

dvec3 seen_from(const Equatorial& place, double sidereal_deg, double latitude_deg) {
  const double hour_angle = std::fmod(sidereal_deg, 360.0) * kDegree - place.right_ascension;
  const double latitude = latitude_deg * kDegree;
  const double across = std::cos(place.declination), along = std::sin(place.declination);
  const double east = -across * std::sin(hour_angle);
  const double north =
      along * std::cos(latitude) - across * std::cos(hour_angle) * std::sin(latitude);
  const double up = along * std::sin(latitude) + across * std::cos(hour_angle) * std::cos(latitude);
  return {east, up, -north};
}

SunAngles lifted_angles(const dvec3& direction) {
  SunAngles angles = angles_of(direction);
  angles.elevation_deg += refraction_deg(angles.elevation_deg);
  return angles;
}

}  // namespace aerostat::scene::detail
