#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <oneapi/tbb/parallel_for.h>

#include "core/math.hpp"
#include "scene_params.h"

namespace aerostat::pack {

/// A map of shadows: its place, and its words for the buffer of texels.
struct ShadowMap {
  AeroShadowMap place{};
  std::vector<std::uint32_t> words;
  /// The mean of the nodes of clouds.
  float mean = 1.0f;
};

/// The nodes of a map along each of its axes.
inline constexpr std::size_t kShadowSide = AERO_SHADOW_SIDE;

/// A sun so high casts no shadows that could be seen in the air: the sine of its distance from the
/// point straight above.
inline constexpr float kLeastLevel = 1e-3f;

/// The axes of a map of shadows: the unit vector towards the sun over the plane, and how steeply
/// the sun's rays rise for each metre over the plane.
struct SunAxes {
  explicit SunAxes(const vec3& sun) : level(std::hypot(sun.x, sun.z)) {
    if (level > kLeastLevel) along = vec2(sun.x, sun.z) / level;
    rise = sun.y / std::max(level, kLeastLevel);
  }

  float u(float x, float z) const { return along.x * x + along.y * z; }
  float v(float x, float z) const { return along.x * z - along.y * x; }
  float x(float u, float v) const { return along.x * u - along.y * v; }
  float z(float u, float v) const { return along.y * u + along.x * v; }

  float level;
  vec2 along{1.0f, 0.0f};
  float rise = 0.0f;
};

/// The nodes of a map of shadows, row by row.
struct ShadowNodes {
  std::vector<float> values;

  float at(std::size_t column, std::size_t row) const {
    return values[std::min(row, kShadowSide - 1) * kShadowSide + std::min(column, kShadowSide - 1)];
  }
};

/// Makes the nodes of a map by `row_of(row, values)`.
ShadowNodes make_nodes(const auto& row_of) {
  ShadowNodes nodes{std::vector<float>(kShadowSide * kShadowSide)};
  tbb::parallel_for(std::size_t{0}, kShadowSide, [&](std::size_t row) {
    row_of(row, std::span(nodes.values).subspan(row * kShadowSide, kShadowSide));
  });
  return nodes;
}

/// Makes the words of a map by `word_of(column, row)`.
std::vector<std::uint32_t> make_words(const auto& word_of) {
  std::vector<std::uint32_t> words(kShadowSide * kShadowSide);
  for (std::size_t row = 0; row < kShadowSide; ++row) {
    for (std::size_t column = 0; column < kShadowSide; ++column) {
      words[row * kShadowSide + column] = word_of(column, row);
    }
  }
  return words;
}

}  // namespace aerostat::pack
