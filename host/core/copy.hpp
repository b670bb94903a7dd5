#pragma once

#include "core/math.hpp"

namespace aerostat {

/// Copies three numbers in the precision of the device.
template <typename Vector>
void copy(float (&to)[3], const Vector& from) {
  to[0] = static_cast<float>(from.x);
  to[1] = static_cast<float>(from.y);
  to[2] = static_cast<float>(from.z);
}

}  // namespace aerostat
