#pragma once

#include <vector>

namespace aerostat::model {

/// A point of the meridian curve. Lengths are in diameters of the envelope, angles in radians.
struct MeridianPoint {
  double radius = 0.0;
  double height = 0.0;     // above the (uncut) lower tip
  double angle = 0.0;      // of the tangent against the vertical, positive outwards
  double curvature = 0.0;  // d angle / d arc length
};

/// The natural shape of a weightless envelope: all tension runs along the meridians. With s the arc
/// length from the lower tip,
///   dr/ds = sin a,  dz/ds = cos a,  da/ds = -k z r,
/// the balance of the gas pressure (proportional to z) with a tension that stays constant; k only
/// sets the scale. The start angle is the one for which the curve closes level: r = 0 where
/// a = -90 degrees. Source: Upson's and Smalley's natural-shape equations with no film weight
/// (J. H. Smalley, "Determination of the Shape of a Free Balloon", 1964, sigma = 0).
class NaturalShape {
 public:
  NaturalShape();

  double arc_length() const { return step_ * static_cast<double>(points_.size() - 1); }
  double height() const { return points_.back().height; }
  /// Half the angle of the cone at the lower tip.
  double start_angle() const { return points_.front().angle; }
  /// In cubic diameters, of the whole, uncut body.
  double volume() const;

  /// `arc` from the lower tip, clamped to the curve.
  MeridianPoint at(double arc) const;

  /// Arc length at which the radius is first (rising) or last (falling) `radius`, in [0, 0.5].
  double arc_below_equator(double radius) const;
  double arc_above_equator(double radius) const;

 private:
  std::vector<MeridianPoint> points_;  // equally spaced by step_
  double step_ = 0.0;
};

/// The one instance; the curve has no parameters.
const NaturalShape& natural_shape();

}  // namespace aerostat::model
