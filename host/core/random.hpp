#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/math.hpp"

namespace aerostat {

/// A repeatable stream of random numbers that is the same on every machine. It is SplitMix64
/// (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// Returns a number in [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double range(double from, double to) { return from + (to - from) * unit(); }
  bool chance(double probability) { return unit() < probability; }
  double turn() { return 2.0 * std::numbers::pi * unit(); }

  /// Returns a direction that is evenly distributed over the unit sphere.
  dvec3 direction() {
    const double y = range(-1.0, 1.0), around = turn();
    const double r = std::sqrt(1.0 - y * y);
    return {r * std::cos(around), y, r * std::sin(around)};
  }

  /// Returns `color` made brighter or darker and warmer or cooler by random amounts up to these
  /// shares.
  vec3 varied(const vec3& color, double brightness, double warmth) {
    const auto level = static_cast<float>(1.0 + range(-brightness, brightness));
    const auto warm = static_cast<float>(range(-warmth, warmth));
    return color * level * vec3(1.0f + warm, 1.0f + 0.25f * warm, 1.0f - 0.7f * warm);
  }

 private:
  std::uint64_t state_;
};

}  // namespace aerostat
