#pragma once

#include "core/simd.hpp"

/// The uniform cubic B-spline.
namespace aerostat {

/// The weights of the four control values around a point.
struct SplineWeights {
  float w0, w1, w2, w3;
};

/// Returns the weights for a point at the share `t`, 0 to 1, of the way from the second control
/// value to the third.
AEROSTAT_INLINE SplineWeights spline_weights(float t) {
  const float s = 1.0f - t;
  return {s * s * s / 6.0f, (3.0f * t * t * t - 6.0f * t * t + 4.0f) / 6.0f,
          (3.0f * s * s * s - 6.0f * s * s + 4.0f) / 6.0f, t * t * t / 6.0f};
}

/// Returns the derivatives of the weights by `t`.
AEROSTAT_INLINE SplineWeights spline_slope_weights(float t) {
  const float s = 1.0f - t;
  return {-0.5f * s * s, 1.5f * t * t - 2.0f * t, -1.5f * s * s + 2.0f * s, 0.5f * t * t};
}

}  // namespace aerostat
