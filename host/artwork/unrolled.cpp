#include "artwork/unrolled.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/envelope_shape.hpp"
#include "model/natural_shape.hpp"

namespace aerostat::artwork {

Unrolled::Unrolled(const scene::Balloon& balloon)
    : diameter_(balloon.diameter_m), gores_(balloon.gores) {
  const model::EnvelopeShape shape(balloon.diameter_m, balloon.gores);
  panels_ = shape.panels();
  mouth_arc_ = shape.mouth_arc();
  disc_height_ = shape.disc_arc() - mouth_arc_;
  disc_ = shape.plate_arc() - shape.disc_arc();
  // The radius rises up to half a diameter, where both functions meet.
  widest_height_ = diameter_ * model::natural_shape().arc_below_equator(0.4999999) - mouth_arc_;
}

double Unrolled::gore_width(double height_m) const {
  const double arc = mouth_arc_ + std::clamp(height_m, 0.0, height());
  const double radius = diameter_ * model::natural_shape().at(arc / diameter_).radius;
  return 2.0 * std::numbers::pi * radius / gores_;
}

double Unrolled::place_of(double around_deg) const {
  // The first tape lies half a gore from the right-hand side, and the heading a quarter of a turn.
  const double turns = (90.0 - around_deg) / 360.0;
  return (turns - std::floor(turns)) * gores_ - 0.5;
}

}  // namespace aerostat::artwork
