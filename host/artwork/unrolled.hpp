#pragma once

#include "scene/balloon.hpp"

/// Pictures on the envelope of a balloon.
namespace aerostat::artwork {

/// The cloth of an envelope laid flat. Heights are metres along the cloth from the mouth, and
/// places around count gores from the first load tape, counter-clockwise as seen from above.
class Unrolled {
 public:
  /// Throws Error{bad_data} unless the balloon's diameter is positive and it has at least 3 gores.
  explicit Unrolled(const scene::Balloon& balloon);

  int gores() const { return gores_; }
  /// Returns the number of panels of a gore between the mouth and the parachute disc.
  int panels() const { return panels_; }
  double diameter() const { return diameter_; }

  /// Returns the height of the rim of the crown's plate, where the cloth ends.
  double height() const { return disc_height_ + disc_; }
  double panel_height() const { return disc_height_ / panels_; }
  /// Returns the length of the cloth from the rim of the parachute disc to that of the plate.
  double disc_length() const { return disc_; }
  /// Returns the height of the widest place.
  double widest_height() const { return widest_height_; }

  /// Returns the width of a gore at a height in metres, which is clamped to the cloth. The bulge of
  /// the gores is left out: it is the way around the envelope over the number of gores.
  double gore_width(double height_m) const;
  double widest_gore() const { return gore_width(widest_height_); }

  /// Returns the place of a direction in gores, 0 to gores(). The direction counts in degrees from
  /// the heading of the balloon, clockwise as seen from above.
  double place_of(double around_deg) const;

 private:
  double diameter_;
  int gores_, panels_;
  double mouth_arc_, disc_height_, disc_, widest_height_;
};

}  // namespace aerostat::artwork
