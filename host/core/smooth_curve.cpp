#include "core/smooth_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aerostat {
namespace {

/// The least distance of two knots, for points that coincide.
constexpr double kLeastKnot = 1e-9;

dvec3 mix(const dvec3& a, const dvec3& b, double from, double to, double x) {
  return a * ((to - x) / (to - from)) + b * ((x - from) / (to - from));
}

}  // namespace

std::size_t piece_of(const std::vector<double>& values, double x) {
  const auto next = std::upper_bound(values.begin() + 1, values.end() - 1, x);
  return static_cast<std::size_t>(next - values.begin()) - 1;
}

SmoothCurve::SmoothCurve(std::vector<dvec3> points) : points_(std::move(points)), knots_{0.0} {
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const double way = glm::distance(points_[i - 1], points_[i]);
    knots_.push_back(knots_.back() + std::max(std::sqrt(way), kLeastKnot));
  }
}

dvec3 SmoothCurve::at(double knot) const {
  if (points_.size() == 1) return points_.front();
  const std::size_t i = piece_of(knots_, knot);
  const dvec3 &p1 = points_[i], &p2 = points_[i + 1];
  const double t1 = knots_[i], t2 = knots_[i + 1];
  // Beyond its ends, the curve goes on as a mirror image.
  const bool is_first = i == 0, is_last = i + 2 == points_.size();
  const dvec3 p0 = is_first ? 2.0 * p1 - p2 : points_[i - 1];
  const dvec3 p3 = is_last ? 2.0 * p2 - p1 : points_[i + 2];
  const double t0 = is_first ? t1 - (t2 - t1) : knots_[i - 1];
  const double t3 = is_last ? t2 + (t2 - t1) : knots_[i + 2];
  const dvec3 a1 = mix(p0, p1, t0, t1, knot), a2 = mix(p1, p2, t1, t2, knot);
  const dvec3 a3 = mix(p2, p3, t2, t3, knot);
  const dvec3 b1 = mix(a1, a2, t0, t2, knot), b2 = mix(a2, a3, t1, t3, knot);
  return mix(b1, b2, t1, t2, knot);
}

}  // namespace aerostat
