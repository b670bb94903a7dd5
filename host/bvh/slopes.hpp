#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "bvh_node.h"
#include "core/math.hpp"

namespace aerostat::bvh {

/// The least and the greatest rise of some ground along x and z, in metres for each metre.
class Slopes {
 public:
  /// Takes in the slopes of a cell, from the heights of its corners (i, j), (i + 1, j), (i, j +
  /// 1) and (i + 1, j + 1). Each triangle rises like two of the edges. A cell of no width makes
  /// the slopes unknown.
  void grow(float a, float b, float c, float d, float width, float depth) {
    grow(x_, (b - a) / width);
    grow(x_, (d - c) / width);
    grow(z_, (c - a) / depth);
    grow(z_, (d - b) / depth);
  }

  /// Returns the slopes as AeroBvhNode holds them, rounded outward.
  std::uint32_t packed() const {
    return byte(x_.lo, -1.0f) | byte(x_.hi, 1.0f) << 8 | byte(z_.lo, -1.0f) << 16 |
           byte(z_.hi, 1.0f) << 24;
  }

  bool known() const { return fits(x_) && fits(z_); }

 private:
  struct Range {
    float lo = kInfinity, hi = -kInfinity;
  };

  static constexpr float kMost = (AERO_SLOPE_ZERO - 2.0f) / AERO_SLOPE_STEPS;

  static void grow(Range& range, float slope) {
    if (!(std::fabs(slope) <= kMost)) slope = std::numeric_limits<float>::quiet_NaN();
    if (std::isnan(slope)) {
      range = {-kInfinity, kInfinity};
      return;
    }
    range.lo = std::min(range.lo, slope);
    range.hi = std::max(range.hi, slope);
  }

  static bool fits(const Range& range) { return range.lo >= -kMost && range.hi <= kMost; }

  // Rounds to the next step outward after adding a hundredth of a step. That is more than all
  // errors of the quotients.
  static std::uint32_t byte(float slope, float outward) {
    const float steps = slope * AERO_SLOPE_STEPS + AERO_SLOPE_ZERO + 0.01f * outward;
    return static_cast<std::uint32_t>(outward > 0.0f ? std::ceil(steps) : std::floor(steps));
  }

  Range x_, z_;
};

/// Returns packed slopes that hold both.
inline std::uint32_t united_slopes(std::uint32_t a, std::uint32_t b) {
  if (a == AERO_SLOPE_UNKNOWN || b == AERO_SLOPE_UNKNOWN) return AERO_SLOPE_UNKNOWN;
  std::uint32_t both = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const std::uint32_t p = a >> shift & 0xffu, q = b >> shift & 0xffu;
    both |= (shift % 16 == 0 ? std::min(p, q) : std::max(p, q)) << shift;
  }
  return both;
}

}  // namespace aerostat::bvh
