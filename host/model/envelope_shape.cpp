#include "model/envelope_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "model/natural_shape.hpp"

namespace aerostat::model {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
/// The radii of the mouth, the parachute disc and the crown's plate, in diameters of the envelope.
constexpr double kMouthRadius = 0.085;
constexpr double kDiscRadius = 0.15;
constexpr double kPlateRadius = 0.014;
/// The bulge of a gore as a share of its width. Chosen by eye.
constexpr double kGoreBulge = 0.075;
/// The bulge of a panel as a share of its height. Chosen by eye.
constexpr double kPanelBulge = 0.014;
constexpr int kPanels = 20;

}  // namespace

EnvelopeShape::EnvelopeShape(double diameter_m, int gores) : diameter_(diameter_m), gores_(gores) {
  if (!(diameter_m > 0.0) || !std::isfinite(diameter_m) || gores < 3) {
    throw Error(ErrorKind::bad_data,
                fmt::format("balloon: a diameter of {} m and {} gores were found; a positive "
                            "diameter and at least 3 gores are needed",
                            diameter_m, gores));
  }
  const NaturalShape& shape = natural_shape();
  mouth_arc_ = diameter_ * shape.arc_below_equator(kMouthRadius);
  disc_arc_ = diameter_ * shape.arc_above_equator(kDiscRadius);
  plate_arc_ = diameter_ * shape.arc_above_equator(kPlateRadius);
  crown_arc_ = diameter_ * shape.arc_length();
  mouth_height_ = diameter_ * shape.at(mouth_arc_ / diameter_).height;
}

int EnvelopeShape::panels() const {
  return kPanels;
}
double EnvelopeShape::mouth_radius() const {
  return kMouthRadius * diameter_;
}
/// Returns the sum of the bulge and of the rise of the natural shape's circle between the ends of
/// the bulge.
double EnvelopeShape::gore_rise() const {
  const double half_turn = 0.5 * kTwoPi / gores_;
  return kGoreBulge * kTwoPi / gores_ * 0.5 * diameter_ +
         0.5 * diameter_ * (1.0 - std::cos(half_turn));
}
double EnvelopeShape::panel_rise() const {
  const double panel = (disc_arc_ - mouth_arc_) / kPanels;
  // The radius of curvature of the meridian is half a diameter at the equator and more elsewhere.
  return kPanelBulge * panel + panel * panel / (4.0 * diameter_);
}
double EnvelopeShape::disc_rise() const {
  const double disc = crown_arc_ - disc_arc_;
  return disc * disc / (4.0 * diameter_);
}

double EnvelopeShape::tape_angle(int gore) const {
  return kTwoPi * (gore + 0.5) / gores_;
}

double EnvelopeShape::height() const {
  return diameter_ * natural_shape().height() - mouth_height_;
}

EnvelopeShape::Bulge EnvelopeShape::bulge(double share, const EnvelopeRow& row, double radius,
                                          double radius_slope) const {
  const double span = disc_arc_ - mouth_arc_;
  const double along = std::clamp((row.arc - mouth_arc_) / span, 0.0, 1.0);
  if (along >= 1.0) return {};
  // The bulge is full over most of the height, and vanishes at the mouth and at the disc.
  const double x = 2.0 * along - 1.0;
  const double fade = 1.0 - x * x * x * x;
  const double fade_slope = -8.0 * x * x * x / span;
  const double across = 4.0 * share * (1.0 - share);
  const double across_slope = 4.0 - 8.0 * share;
  const double panel = span / kPanels;
  const double f = row.panel_share;
  const double gore = kGoreBulge * kTwoPi / gores_;
  const double swell = gore * radius + kPanelBulge * panel * 4.0 * f * (1.0 - f);
  const double swell_slope = gore * radius_slope + kPanelBulge * (4.0 - 8.0 * f);
  return {fade * across * swell, across * (fade_slope * swell + fade * swell_slope),
          fade * across_slope * swell};
}

FabricPoint EnvelopeShape::fabric(int gore, double share, const EnvelopeRow& row) const {
  const MeridianPoint meridian = natural_shape().at(row.arc / diameter_);
  const double sine = std::sin(meridian.angle), cosine = std::cos(meridian.angle);
  const double radius = meridian.radius * diameter_;
  const Bulge b = bulge(share, row, radius, sine);
  const double out = radius + b.height * cosine;
  const double turn = kTwoPi / gores_;
  const double angle = tape_angle(gore) + turn * share;
  const dvec3 radial(std::cos(angle), 0.0, -std::sin(angle));
  const dvec3 around(-std::sin(angle), 0.0, -std::cos(angle));
  const double bend = b.height * meridian.curvature / diameter_;
  const dvec2 per_arc(sine + b.per_arc * cosine - bend * sine,
                      cosine - b.per_arc * sine - bend * cosine);
  // The terms are divided by the radius, so that the point of the crown has a normal too.
  const double scale = radius > 0.0 ? 1.0 / radius : 0.0;
  const double a = b.per_share * cosine * scale, c = -b.per_share * sine * scale;
  const double width = radius > 0.0 ? turn * out * scale : turn;
  const dvec3 normal = width * per_arc.y * radial - dvec3(0.0, width * per_arc.x, 0.0) +
                       (c * per_arc.x - a * per_arc.y) * around;
  return {
      out * radial + dvec3(0.0, meridian.height * diameter_ - b.height * sine - mouth_height_, 0.0),
      glm::normalize(normal), around};
}

}  // namespace aerostat::model
