#pragma once

#include "core/math.hpp"
#include "scene/sun_angles.hpp"

/// Directions in the sky: the turning of the Earth, and what sun, moon and stars have in common.
/// Days count from noon (universal time) of 1 January 2000. Source: J. Meeus, "Astronomical
/// Algorithms" (2nd ed., 1998).
namespace aerostat::scene::detail {

inline constexpr double kDegree = std::numbers::pi / 180.0;
inline constexpr double kDaysPerCentury = 36525.0;

/// A place among the stars in radians.
struct Equatorial {
  double right_ascension = 0.0;
  double declination = 0.0;
};

/// The slow swing of the Earth's axis, in degrees.
struct Nutation {
  double longitude_deg = 0.0;
  double obliquity_deg = 0.0;  // of the true equator to the ecliptic
};

/// Returns the Julian centuries from 2000 in the time that orbits follow. Universal time lags
/// behind it by 64 to 69 s between 2000 and 2025.
double orbit_centuries(double days_from_2000);

/// Returns the nutation to 0.001 degrees (chapter 22). `t` is in centuries from 2000.
Nutation nutation_at(double t);

/// Returns the place of an ecliptic longitude and latitude in degrees.
Equatorial equatorial_of(double longitude_deg, double latitude_deg, double obliquity_deg);

/// Returns the mean sidereal time of Greenwich in degrees, which grows beyond 360 (formula 12.4).
double sidereal_deg_at(double days_from_2000);

/// Returns the unit vector of a place, with x to the east, y up and z to the south, without
/// refraction. `sidereal_deg` is the sidereal time of the observer's own longitude.
dvec3 seen_from(const Equatorial& place, double sidereal_deg, double latitude_deg);

/// Returns the angles of a direction, lifted by refraction in mean air (formula 16.4). Nothing is
/// lifted that stands lower than 1 degree below the horizon.
SunAngles lifted_angles(const dvec3& direction);

}  // namespace aerostat::scene::detail
