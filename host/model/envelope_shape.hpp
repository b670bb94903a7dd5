#pragma once

#include <vector>

#include "core/math.hpp"

namespace aerostat::model {

/// A height on the envelope.
struct EnvelopeRow {
  /// The arc length along the natural shape from the uncut lower tip, in metres.
  double arc = 0.0;
  /// The place within the panel, from 0 at its lower seam to 1 at its upper one.
  double panel_share = 0.0;
};

/// A point of the envelope's fabric with the frame of the surface at it.
struct FabricPoint {
  dvec3 position{0.0};
  /// The outward unit normal.
  dvec3 normal{0.0};
  /// The unit tangent towards the next gore.
  dvec3 around{0.0};
};

/// The surface of the envelope in metres, with y = 0 at the mouth and the axis x = z = 0. It is the
/// natural shape, cut off at the mouth. Its gores bulge between the load tapes, and its panels
/// bulge a little between their seams. Gore g begins at the tape at angle 2 pi (g + 1/2) / gores,
/// counted from +x towards -z, so that the tapes of four corners mirror each other.
class EnvelopeShape {
 public:
  /// Makes the shape. Throws Error{bad_data} unless diameter > 0 and gores >= 3.
  EnvelopeShape(double diameter_m, int gores);

  double diameter() const { return diameter_; }
  int gores() const { return gores_; }
  int panels() const;

  double mouth_radius() const;
  /// Returns the height from the mouth to the crown in metres.
  double height() const;
  double mouth_arc() const { return mouth_arc_; }
  /// Returns the arc length at the rim of the parachute disc, in metres.
  double disc_arc() const { return disc_arc_; }
  /// Returns the arc length at the rim of the crown's plate, in metres.
  double plate_arc() const { return plate_arc_; }
  double crown_arc() const { return crown_arc_; }

  /// Returns the largest distance of the surface from a chord across a gore, in metres.
  /// `panel_rise` returns that of chords up a panel, and `disc_rise` that of chords over the disc.
  double gore_rise() const;
  double panel_rise() const;
  double disc_rise() const;
  /// Returns the angle in radians of the tape at which gore `gore` begins.
  double tape_angle(int gore) const;

  /// Returns the point of gore `gore` at `share`, which runs from 0 to 1 between its tapes.
  FabricPoint fabric(int gore, double share, const EnvelopeRow& row) const;

 private:
  struct Bulge {
    /// The height of the bulge along the normal of the natural shape.
    double height = 0.0;
    /// The derivatives of the height by arc length and by share.
    double per_arc = 0.0;
    double per_share = 0.0;
  };
  Bulge bulge(double share, const EnvelopeRow& row, double radius, double radius_slope) const;

  double diameter_;
  int gores_;
  /// The height of the mouth above the uncut lower tip, in metres.
  double mouth_height_;
  double mouth_arc_, disc_arc_, plate_arc_, crown_arc_;
};

}  // namespace aerostat::model
