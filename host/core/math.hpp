#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include <glm/glm.hpp>

namespace aerostat {

using glm::dvec2;
using glm::dvec3;
using glm::uvec3;
using glm::vec2;
using glm::vec3;

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr float radians_from_degrees(float degrees) {
  return degrees * (kPi / 180.0f);
}
constexpr float degrees_from_radians(float radians) {
  return radians * (180.0f / kPi);
}

/// Returns whether no component is NaN or infinite.
inline bool is_finite(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Returns the unit vector towards a point of the sky. Azimuth 0 is -z ("north"), 90 degrees is
/// +x ("east").
inline vec3 direction_from_angles(float azimuth_rad, float elevation_rad) {
  return {std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad),
          -std::cos(elevation_rad) * std::cos(azimuth_rad)};
}

}  // namespace aerostat
