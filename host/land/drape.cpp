#include "land/drape.hpp"

#include <algorithm>
#include <cmath>

namespace aerostat::land {
namespace {

/// A level counts up to this share of its side from the middle. The rest is a margin.
constexpr double kReachOfLevel = 0.45;
/// Over so large a share of its reach, a level gives way to the next one.
constexpr double kFade = 0.2;

std::uint32_t byte_of(float value) {
  return static_cast<std::uint32_t>(std::clamp(255.0f * value + 0.5f, 0.0f, 255.0f));
}

}  // namespace

std::uint32_t packed_texel(const vec4& colour) {
  const vec4 held = glm::clamp(colour, vec4(0.0f), vec4(1.0f));
  return byte_of(std::sqrt(held.x)) | byte_of(std::sqrt(held.y)) << 8 |
         byte_of(std::sqrt(held.z)) << 16 | byte_of(held.w) << 24;
}

vec4 colour_of_texel(std::uint32_t texel) {
  const auto byte = [&](int shift) { return static_cast<float>(texel >> shift & 255u) / 255.0f; };
  const vec3 root(byte(0), byte(8), byte(16));
  return vec4(root * root, byte(24));
}

vec4 Drape::level_at(int level, const dvec2& from_middle) const {
  const double texel = std::ldexp(texel_m_, level);
  const dvec2 place = glm::clamp(from_middle / texel + 0.5 * side_ - 0.5, 0.0, side_ - 1.001);
  const dvec2 cell = glm::floor(place);
  const vec2 share(place - cell);
  const auto side = static_cast<std::size_t>(side_);
  const std::uint32_t* at =
      texels_.data() +
      (static_cast<std::size_t>(level) * side + static_cast<std::size_t>(cell.y)) * side +
      static_cast<std::size_t>(cell.x);
  const vec4 upper = glm::mix(colour_of_texel(at[0]), colour_of_texel(at[1]), share.x);
  const vec4 lower = glm::mix(colour_of_texel(at[side]), colour_of_texel(at[side + 1]), share.x);
  return glm::mix(upper, lower, share.y);
}

vec4 Drape::at(double east_m, double south_m, double footprint_m) const {
  const dvec2 from_middle = dvec2(east_m, south_m) - middle_;
  const double away = std::max({std::abs(from_middle.x), std::abs(from_middle.y), 1e-3});
  const double reach = kReachOfLevel * side_ * texel_m_;
  if (away > std::ldexp(reach, levels_ - 1)) return vec4(0.0f);
  const double finest = std::max(std::ceil(std::log2(away / reach)), 0.0);
  const double detail = std::max(std::log2(std::max(footprint_m, 1e-6) / texel_m_), finest);
  const int level = static_cast<int>(std::min(std::floor(detail), levels_ - 1.0));
  const double rim = (away / std::ldexp(reach, level) - (1.0 - kFade)) / kFade;
  const double share = std::clamp(std::max(detail - level, rim), 0.0, 1.0);
  return glm::mix(level_at(level, from_middle),
                  level_at(std::min(level + 1, levels_ - 1), from_middle),
                  static_cast<float>(share));
}

}  // namespace aerostat::land
