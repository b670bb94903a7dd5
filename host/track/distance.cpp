#include "track/distance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/earth.hpp"
#include "core/math.hpp"

namespace aerostat::track {

namespace {

/// Returns the point of the ellipsoid WGS 84 at a place, in metres from the middle of the Earth.
dvec3 point_of(const geo::Place& place) {
  constexpr double kEquator_m = 6378137.0;
  constexpr double kEccentricity2 = 6.69437999014e-3;
  const double latitude = place.latitude_deg * std::numbers::pi / 180.0;
  const double longitude = place.longitude_deg * std::numbers::pi / 180.0;
  const double sine = std::sin(latitude);
  const double radius_m = kEquator_m / std::sqrt(1.0 - kEccentricity2 * sine * sine);
  return {radius_m * std::cos(latitude) * std::cos(longitude),
          radius_m * std::cos(latitude) * std::sin(longitude),
          radius_m * (1.0 - kEccentricity2) * sine};
}

}  // namespace

double distance_m(const geo::Place& a, const geo::Place& b) {
  const dvec3 between = point_of(a) - point_of(b);
  const double chord =
      std::sqrt(between.x * between.x + between.y * between.y + between.z * between.z);
  const double half = std::min(1.0, chord / (2.0 * kEarthRadius_m));
  return 2.0 * kEarthRadius_m * std::asin(half);
}

double unwrapped(double longitude_deg, double near_deg) {
  return longitude_deg - 360.0 * std::round((longitude_deg - near_deg) / 360.0);
}

double wrapped(double longitude_deg) {
  const double near_zero = unwrapped(longitude_deg, 0.0);
  return near_zero == -180.0 ? 180.0 : near_zero;
}

}  // namespace aerostat::track
