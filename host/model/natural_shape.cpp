#include "model/natural_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aerostat::model {
namespace {

constexpr double kHalfPi = std::numbers::pi / 2.0;
constexpr int kSamples = 2048;

// The angle at the lower tip with which the curve reaches the axis level, and the arc length of
// this curve, both for k = 1. The equations have no parameters, so their solution is constant. The
// values were found by bisection with steps of 1 / 4096.
constexpr double kStartAngle = 0.87526253164042, kArc = 3.17283626559749;

struct State {
  double radius = 0.0, height = 0.0, angle = 0.0;
};

State derivative(const State& state) {
  return {std::sin(state.angle), std::cos(state.angle), -state.height * state.radius};
}

State advanced(const State& state, const State& slope, double step) {
  return {state.radius + step * slope.radius, state.height + step * slope.height,
          state.angle + step * slope.angle};
}

/// Returns the state after one step of the classical Runge-Kutta method.
State runge_kutta(const State& state, double step) {
  const State k1 = derivative(state);
  const State k2 = derivative(advanced(state, k1, step / 2.0));
  const State k3 = derivative(advanced(state, k2, step / 2.0));
  const State k4 = derivative(advanced(state, k3, step));
  State next = advanced(state, k1, step / 6.0);
  next = advanced(next, k2, step / 3.0);
  next = advanced(next, k3, step / 3.0);
  return advanced(next, k4, step / 6.0);
}

double hermite(double a, double b, double slope_a, double slope_b, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * a + (t3 - 2.0 * t2 + t) * slope_a +
         (3.0 * t2 - 2.0 * t3) * b + (t3 - t2) * slope_b;
}

}  // namespace

NaturalShape::NaturalShape() {
  constexpr double step = kArc / kSamples;
  State state{0.0, 0.0, kStartAngle};
  double widest = 0.0;
  points_.reserve(kSamples + 1);
  for (int i = 0; i <= kSamples; ++i) {
    points_.push_back({state.radius, state.height, state.angle, 0.0});
    widest = std::max(widest, state.radius);
    state = runge_kutta(state, step);
  }
  points_.back().radius = 0.0;
  points_.back().angle = -kHalfPi;
  const double diameter = 2.0 * widest;
  step_ = step / diameter;
  const double scale_cubed = diameter * diameter * diameter;
  for (MeridianPoint& point : points_) {
    point.radius /= diameter;
    point.height /= diameter;
    point.curvature = -point.height * point.radius * scale_cubed;
  }
}

double NaturalShape::volume() const {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const MeridianPoint &a = points_[i], &b = points_[i + 1];
    const double squares = a.radius * a.radius + a.radius * b.radius + b.radius * b.radius;
    sum += squares * (b.height - a.height) / 3.0;
  }
  return std::numbers::pi * sum;
}

MeridianPoint NaturalShape::at(double arc) const {
  const double position = std::clamp(arc / step_, 0.0, static_cast<double>(points_.size() - 1));
  const std::size_t index = std::min(static_cast<std::size_t>(position), points_.size() - 2);
  const double t = position - static_cast<double>(index);
  const MeridianPoint &a = points_[index], &b = points_[index + 1];
  MeridianPoint point;
  point.radius =
      hermite(a.radius, b.radius, step_ * std::sin(a.angle), step_ * std::sin(b.angle), t);
  point.height =
      hermite(a.height, b.height, step_ * std::cos(a.angle), step_ * std::cos(b.angle), t);
  point.angle = hermite(a.angle, b.angle, step_ * a.curvature, step_ * b.curvature, t);
  point.curvature = a.curvature + t * (b.curvature - a.curvature);
  return point;
}

double NaturalShape::arc_below_equator(double radius) const {
  const auto beyond = [radius](const MeridianPoint& p) { return p.radius >= radius; };
  const auto found = std::find_if(points_.begin() + 1, points_.end() - 1, beyond);
  const auto before = found - 1;
  const double t = (radius - before->radius) / (found->radius - before->radius);
  return step_ * (static_cast<double>(before - points_.begin()) + t);
}

double NaturalShape::arc_above_equator(double radius) const {
  const auto beyond = [radius](const MeridianPoint& p) { return p.radius >= radius; };
  const auto found = std::find_if(points_.rbegin() + 1, points_.rend() - 1, beyond);
  const auto after = found - 1;
  const double t = (found->radius - radius) / (found->radius - after->radius);
  return step_ * (static_cast<double>(points_.rend() - found - 1) + t);
}

const NaturalShape& natural_shape() {
  static const NaturalShape shape;
  return shape;
}

}  // namespace aerostat::model
