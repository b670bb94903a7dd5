#pragma once

#include <algorithm>
#include <concepts>

namespace aerostat {

/// Returns the cubic that rises from 0 at t = 0 to 1 at t = 1 and is level at both ends. Expects
/// 0 <= t <= 1.
template <std::floating_point T>
constexpr T smooth_unit_step(T t) {
  return t * t * (T{3} - T{2} * t);
}

/// Returns 0 up to `from` and 1 beyond `to`, with a continuous slope between them. from > to
/// reverses it.
template <std::floating_point T>
constexpr T smooth_step(T from, T to, T x) {
  return smooth_unit_step(std::clamp((x - from) / (to - from), T{0}, T{1}));
}

}  // namespace aerostat
