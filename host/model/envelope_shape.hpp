#pragma once

#include <vector>

#include "core/math.hpp"

namespace aerostat::model {

/// A height on the envelope.
struct EnvelopeRow {
  double arc = 0.0;          // along the natural shape, in metres from the uncut tip
  double panel_share = 0.0;  // 0 at the panel's lower seam, 1 at its upper one
};

/// A point of the envelope's fabric and the frame of its surface there.
struct FabricPoint {
  dvec3 position{0.0};
  dvec3 normal{0.0};  // unit, outwards
  dvec3 around{0.0};  // unit, towards the next gore
};

/// The surface of the envelope in metres, y = 0 at the mouth, axis x = z = 0: the natural shape,
/// cut off at the mouth, with gores that bulge between the load tapes and panels that bulge a
/// little between their seams. Gore g begins at the tape at angle 2 pi (g + 1/2) / gores, counted
/// from +x towards -z, so that the tapes of four corners mirror each other.
class EnvelopeShape {
 public:
  /// Throws Error{bad_data} unless diameter > 0 and gores >= 3.
  EnvelopeShape(double diameter_m, int gores);

  double diameter() const { return diameter_; }
  int gores() const { return gores_; }
  int panels() const;

  double mouth_radius() const;
  double height() const;  // mouth to crown
  double mouth_arc() const { return mouth_arc_; }
  double disc_arc() const { return disc_arc_; }    // rim of the parachute disc
  double plate_arc() const { return plate_arc_; }  // rim of the crown's plate
  double crown_arc() const { return crown_arc_; }

  /// The largest distances of the surface from chords across a gore, up a panel, over the disc.
  double gore_rise() const;
  double panel_rise() const;
  double disc_rise() const;
  /// Angle of the tape at which gore `gore` begins.
  double tape_angle(int gore) const;

  /// The fabric of gore `gore` at `share` (0 to 1 between its tapes).
  FabricPoint fabric(int gore, double share, const EnvelopeRow& row) const;

 private:
  struct Bulge {
    double height = 0.0;   // along the normal of the natural shape
    double per_arc = 0.0;  // its derivatives
    double per_share = 0.0;
  };
  Bulge bulge(double share, const EnvelopeRow& row, double radius, double radius_slope) const;

  double diameter_;
  int gores_;
  double mouth_height_;  // above the uncut tip
  double mouth_arc_, disc_arc_, plate_arc_, crown_arc_;
};

}  // namespace aerostat::model
