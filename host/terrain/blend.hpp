#pragma once

#include <algorithm>
#include <cmath>

namespace aerostat::terrain {

/// 0 up to `from`, 1 beyond `to`, with a continuous slope between (from > to reverses it).
inline float ramp(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

inline float mix(float a, float b, float t) {
  return a + t * (b - a);
}

/// std::hypot of values that are far from the ends of their range, in loops that are vectorised.
inline float length_of(float x, float y) {
  const double dx = x, dy = y;
  return static_cast<float>(std::sqrt(dx * dx + dy * dy));
}

/// The lesser of two values, rounded where they differ by less than `radius` (never greater).
inline float smooth_min(float a, float b, float radius) {
  if (!(radius > 0.0f)) return std::min(a, b);
  const float h = std::max(radius - std::fabs(a - b), 0.0f) / radius;
  return std::min(a, b) - 0.25f * h * h * radius;
}

inline float smooth_max(float a, float b, float radius) {
  return -smooth_min(-a, -b, radius);
}

}  // namespace aerostat::terrain
