#include "model/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aerostat::model {
namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2.0;

Outline::Point point_at_angle(const dvec2& center, double radius, double angle) {
  const dvec3 normal(std::cos(angle), 0.0, -std::sin(angle));
  const dvec3 tangent(-std::sin(angle), 0.0, -std::cos(angle));
  return {dvec3(center.x, 0.0, center.y) + radius * normal, normal, tangent};
}

}  // namespace

double Outline::length() const {
  const dvec2 straight = 2.0 * (half - dvec2(corner_radius));
  return 2.0 * (straight.x + straight.y) + 4.0 * kQuarterTurn * corner_radius;
}

Outline::Point Outline::at(double distance) const {
  const dvec2 inner = half - dvec2(corner_radius);
  const double arc = kQuarterTurn * corner_radius;
  const double quarter = inner.x + inner.y + arc;
  double rest = std::fmod(distance, 4.0 * quarter);
  if (rest < 0.0) rest += 4.0 * quarter;
  const int turn = std::min(static_cast<int>(rest / quarter), 3);
  rest -= turn * quarter;
  // Every quarter begins in the middle of a side. `lead` is the first of its two half sides.
  const double lead = turn % 2 == 0 ? inner.y : inner.x;
  const double angle = turn * kQuarterTurn;
  const Point side = point_at_angle({0.0, 0.0}, 0.0, angle);
  const Point next = point_at_angle({0.0, 0.0}, 0.0, angle + kQuarterTurn);
  const double out = turn % 2 == 0 ? half.x : half.y;
  const double next_out = turn % 2 == 0 ? half.y : half.x;
  if (rest < lead) return {out * side.normal + rest * side.tangent, side.normal, side.tangent};
  rest -= lead;
  if (rest < arc) {
    const dvec3 center = (out - corner_radius) * side.normal + lead * side.tangent;
    return point_at_angle({center.x, center.z}, corner_radius, angle + rest / corner_radius);
  }
  rest -= arc;
  const double follow = out - corner_radius - rest;
  return {next_out * next.normal - follow * next.tangent, next.normal, next.tangent};
}

dvec3 Outline::corner(double sign_x, double sign_z) const {
  const double reach = corner_radius * std::numbers::sqrt2 / 2.0;
  return {sign_x * (half.x - corner_radius + reach), 0.0,
          sign_z * (half.y - corner_radius + reach)};
}

}  // namespace aerostat::model
