#pragma once

#include "core/math.hpp"

namespace aerostat::model {

/// A closed curve in a level plane: a rectangle of half sizes `half` (x, z) with rounded corners.
/// It runs counter-clockwise as seen from above and starts in the middle of the +x side.
struct Outline {
  dvec2 half{1.0};
  double corner_radius = 0.1;

  struct Point {
    /// The position, with y = 0.
    dvec3 position{0.0};
    /// The outward, level normal.
    dvec3 normal{0.0};
    /// The tangent in the direction of the curve.
    dvec3 tangent{0.0};
  };

  double length() const;
  /// Returns the point at `distance` along the curve, which may have any value.
  Point at(double distance) const;
  /// Returns the point that lies farthest out on the corner arc towards (sign_x, sign_z).
  dvec3 corner(double sign_x, double sign_z) const;
};

}  // namespace aerostat::model
