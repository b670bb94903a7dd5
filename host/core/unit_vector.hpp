#pragma once

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace aerostat {

/// `v` times the power of two that brings its largest component between 1 and 2: its squares
/// neither vanish nor overflow. `v` is finite and not null.
inline dvec3 brought_to_one(const dvec3& v) {
  const int exponent = std::ilogb(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
  return {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
}

/// Unit vector of one that is finite and not null, however short or long; the same bits as
/// glm::normalize where the squares of its components are normal numbers.
inline dvec3 unit(const dvec3& v) {
  return glm::normalize(brought_to_one(v));
}

}  // namespace aerostat
