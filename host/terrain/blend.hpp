#pragma once

#include <algorithm>
#include <cmath>

namespace aerostat::terrain {

inline float mix(float a, float b, float t) {
  return a + t * (b - a);
}

/// Returns std::hypot(x, y) of values that are far from the ends of their range. Loops with this
/// function can be vectorised.
inline float length_of(float x, float y) {
  const double dx = x, dy = y;
  return static_cast<float>(std::sqrt(dx * dx + dy * dy));
}

/// Returns the lesser of two values. Where they differ by less than `radius`, the result is
/// rounded off and lies below both.
inline float smooth_min(float a, float b, float radius) {
  if (!(radius > 0.0f)) return std::min(a, b);
  const float h = std::max(radius - std::fabs(a - b), 0.0f) / radius;
  return std::min(a, b) - 0.25f * h * h * radius;
}

/// Returns the greater of two values. Where they differ by less than `radius`, the result is
/// rounded off and lies above both.
inline float smooth_max(float a, float b, float radius) {
  return -smooth_min(-a, -b, radius);
}

}  // namespace aerostat::terrain
