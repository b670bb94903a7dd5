#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/math.hpp"

namespace aerostat::land {

/// A raster over the land in levels of detail: squares around one point of the local frame, with
/// the same number of texels each. Each is twice as wide as the one before, so that what is near
/// the point is as fine as in the file and the whole land is covered. Kernels read the same.
struct NestedLevels {
  int side = 0, levels = 0;
  double texel_m = 1.0;               // width of a texel of the first level
  dvec2 middle{0.0};                  // of all levels, in metres to the east and to the south
  std::vector<std::uint32_t> texels;  // level by level and row by row from the north-west
};

/// A level counts up to this share of its side from the middle. The rest is a margin.
inline constexpr double kReachOfLevel = 0.45;

/// Returns a level at a point, between the four texels around it. `unpack` turns a texel into a
/// value that glm::mix() takes.
template <class Unpack>
auto level_at(const NestedLevels& nested, int level, const dvec2& from_middle,
              const Unpack& unpack) {
  const double texel = std::ldexp(nested.texel_m, level);
  const dvec2 place =
      glm::clamp(from_middle / texel + 0.5 * nested.side - 0.5, 0.0, nested.side - 1.001);
  const dvec2 cell = glm::floor(place);
  const vec2 share(place - cell);
  const auto side = static_cast<std::size_t>(nested.side);
  const std::uint32_t* at =
      nested.texels.data() +
      (static_cast<std::size_t>(level) * side + static_cast<std::size_t>(cell.y)) * side +
      static_cast<std::size_t>(cell.x);
  const auto upper = mix(unpack(at[0]), unpack(at[1]), share.x);
  const auto lower = mix(unpack(at[side]), unpack(at[side + 1]), share.x);
  return mix(upper, lower, share.y);
}

/// Returns the value at a point of the local frame, filtered over a footprint in metres. Beyond the
/// last level it is `outside`.
template <class Value, class Unpack>
Value nested_at(const NestedLevels& nested, const dvec2& point, double footprint_m,
                const Value& outside, const Unpack& unpack) {
  /// Over so large a share of its reach, a level gives way to the next one.
  constexpr double kFade = 0.2;
  const dvec2 from_middle = point - nested.middle;
  const double away = std::max({std::abs(from_middle.x), std::abs(from_middle.y), 1e-3});
  const double reach = kReachOfLevel * nested.side * nested.texel_m;
  if (away > std::ldexp(reach, nested.levels - 1)) return outside;
  const double finest = std::max(std::ceil(std::log2(away / reach)), 0.0);
  const double detail = std::max(std::log2(std::max(footprint_m, 1e-6) / nested.texel_m), finest);
  const int level = static_cast<int>(std::min(std::floor(detail), nested.levels - 1.0));
  const double rim = (away / std::ldexp(reach, level) - (1.0 - kFade)) / kFade;
  const double share = std::clamp(std::max(detail - level, rim), 0.0, 1.0);
  return mix(level_at(nested, level, from_middle, unpack),
             level_at(nested, std::min(level + 1, nested.levels - 1), from_middle, unpack),
             static_cast<float>(share));
}

}  // namespace aerostat::land
