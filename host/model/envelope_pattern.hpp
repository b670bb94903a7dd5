#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace aerostat::model {

/// Which colour of the balloon's palette each piece of fabric has. Places are given as gores around
/// (0 to gores) and panels up (0 at the mouth to panels at the parachute disc).
///
/// Stripes, rainbow and checker change colour from panel to panel only. Chevrons and spiral run
/// across panels: their colour changes where `phase` passes a whole number.
class EnvelopePattern {
 public:
  /// Throws Error{bad_data} if there is no colour. Components are clamped to [0, 1].
  EnvelopePattern(const scene::Balloon& balloon, int panels);

  bool crosses_panels() const;
  /// Only where crosses_panels(); linear within a gore.
  double phase(double gores_around, double panels_up) const;
  /// What `phase` gains in one turn; a whole multiple of the palette's size.
  double phase_per_turn() const;

  /// `band` is the whole part of the phase, and unused unless crosses_panels().
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
