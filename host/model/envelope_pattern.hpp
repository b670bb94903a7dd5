#pragma once

#include <vector>

#include "scene/balloon.hpp"

namespace aerostat::model {

/// Determines the colour of each piece of fabric from the balloon's palette. Places are given as
/// gores around (0 to gores) and panels up (0 at the mouth to panels at the parachute disc).
/// Stripes, rainbow and checker change their colour only from panel to panel. Chevrons and spiral
/// run across panels, and their colour changes where `phase` passes a whole number.
class EnvelopePattern {
 public:
  /// Makes the pattern of a balloon. Throws Error{bad_data} if there is no colour. The components
  /// of colours are clamped to [0, 1].
  EnvelopePattern(const scene::Balloon& balloon, int panels);

  bool crosses_panels() const;
  /// Returns the phase at a place. It may be called only if crosses_panels() is true, and it is
  /// linear within half a gore.
  double phase(double gores_around, double panels_up) const;
  /// Returns the increase of `phase` in one turn, which is a whole multiple of the palette's size.
  double phase_per_turn() const;

  /// Returns the colour of a piece of fabric. `band` is the whole part of the phase. It is used
  /// only if crosses_panels() is true.
  vec3 fabric(int gore, int panel, int band) const;

  vec3 crown() const { return crown_; }
  vec3 skirt() const;
  vec3 tape() const { return tape_; }

 private:
  std::size_t color_index(int gore, int panel, int band) const;

  scene::Pattern pattern_;
  int gores_;
  int panels_;
  std::vector<vec3> palette_;
  vec3 trim_, crown_, tape_;
};

}  // namespace aerostat::model
