#pragma once

#include "core/math.hpp"

namespace aerostat::model {

/// A closed curve in plan: a rectangle of half sizes `half` (x, z) with rounded corners. It runs
/// counter-clockwise seen from above and starts in the middle of the +x side.
struct Outline {
  dvec2 half{1.0};
  double corner_radius = 0.1;

  struct Point {
    dvec3 position{0.0};  // y = 0
    dvec3 normal{0.0};    // outwards, level
    dvec3 tangent{0.0};   // the way the curve runs
  };

  double length() const;
  /// `distance` along the curve, any value.
  Point at(double distance) const;
  /// The point of the corner arc towards (sign_x, sign_z) that lies farthest out.
  dvec3 corner(double sign_x, double sign_z) const;
};

}  // namespace aerostat::model
