#include "land/drape.hpp"

#include <algorithm>
#include <cmath>

namespace aerostat::land {
namespace {

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

vec4 Drape::at(double east_m, double south_m, double footprint_m) const {
  return nested_at(levels_, {east_m, south_m}, footprint_m, vec4(0.0f), colour_of_texel);
}

}  // namespace aerostat::land
