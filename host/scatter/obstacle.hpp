#pragma once

#include "core/math.hpp"

namespace aerostat::scatter {

/// An object that stands among the plants or hovers above them. Plants leave room for it, and those
/// around it matter to a picture that shows it.
struct Obstacle {
  dvec3 position{0.0};  // its foot, in world coordinates
  double width_m = 0.0;
  bool above_ground = false;  // y counts from the ground below the object

  bool operator==(const Obstacle&) const = default;
};

}  // namespace aerostat::scatter
