#pragma once

#include <vector>

namespace aerostat::model {

/// A point of the meridian curve. Lengths are in diameters of the envelope, angles in radians.
struct MeridianPoint {
  double radius = 0.0;
  /// The height above the uncut lower tip.
  double height = 0.0;
  /// The angle of the tangent against the vertical, positive outwards.
  double angle = 0.0;
  /// The derivative of the angle by arc length.
  double curvature = 0.0;
};

/// The natural shape of a weightless envelope, in which all tension runs along the meridians. With
/// s the arc length from the lower tip, the curve obeys
///   dr/ds = sin a,  dz/ds = cos a,  da/ds = -k z r,
/// which is the balance of the gas pressure (proportional to z) with a constant tension. k only
/// sets the scale. The start angle is the one for which the curve closes level: r = 0 where a = -90
/// degrees. Source: Upson's and Smalley's natural-shape equations without film weight (J. H.
/// Smalley, "Determination of the Shape of a Free Balloon", 1964, sigma = 0).
class NaturalShape {
 public:
  NaturalShape();

  double arc_length() const { return step_ * static_cast<double>(points_.size() - 1); }
  double height() const { return points_.back().height; }
  /// Returns half the angle of the cone at the lower tip, in radians.
  double start_angle() const { return points_.front().angle; }
  /// Returns the volume of the whole, uncut body in cubic diameters.
  double volume() const;

  /// Returns the point at `arc` from the lower tip. `arc` is clamped to the curve.
  MeridianPoint at(double arc) const;

  /// Returns the arc length at which the radius rises to `radius`, which lies in [0, 0.5].
  /// `arc_above_equator` returns the arc length at which it falls to `radius`.
  double arc_below_equator(double radius) const;
  double arc_above_equator(double radius) const;

 private:
  /// Points of the curve at equal arc lengths of step_.
  std::vector<MeridianPoint> points_;
  double step_ = 0.0;
};

/// Returns the only instance, because the curve has no parameters.
const NaturalShape& natural_shape();

}  // namespace aerostat::model
