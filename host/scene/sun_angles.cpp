#include "scene/sun_angles.hpp"

#include <cmath>
#include <numbers>

namespace aerostat::scene::detail {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

}  // namespace

SunAngles angles_of(const dvec3& direction) {
  const double level = std::hypot(direction.x, direction.z);
  return {std::atan2(direction.x, -direction.z) / kDegree,
          std::atan2(direction.y, level) / kDegree};
}

dvec3 direction_of(const SunAngles& angles) {
  const double azimuth = angles.azimuth_deg * kDegree;
  const double elevation = angles.elevation_deg * kDegree;
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
          -std::cos(elevation) * std::cos(azimuth)};
}

}  // namespace aerostat::scene::detail
