#pragma once

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace aerostat {

/// Returns `v` times the power of two that brings its largest component between 1 and 2, so that
/// its squares neither vanish nor overflow. `v` must be finite and not null.
inline dvec3 brought_to_one(const dvec3& v) {
  const int exponent = std::ilogb(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
  return {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
}

/// Returns the unit vector of `v`, which may have any length but must be finite and not null. The
/// bits are those of glm::normalize where the squares of the components are normal numbers.
inline dvec3 unit(const dvec3& v) {
  return glm::normalize(brought_to_one(v));
}

}  // namespace aerostat
