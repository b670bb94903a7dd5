#include "film/curve.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace aerostat::film {
namespace {

/// Pieces of the curve's length between two points. At 200, the speed of a sharp bend is even to
/// within a thousandth (measured in the test).
constexpr std::size_t kPieces = 200;

/// The least distance of two knots, for points that coincide.
constexpr double kLeastKnot = 1e-9;

/// Returns the index of the piece of rising values that holds `x`.
std::size_t piece_of(const std::vector<double>& values, double x) {
  const auto next = std::upper_bound(values.begin() + 1, values.end() - 1, x);
  return static_cast<std::size_t>(next - values.begin()) - 1;
}

dvec3 mix(const dvec3& a, const dvec3& b, double from, double to, double x) {
  return a * ((to - x) / (to - from)) + b * ((x - from) / (to - from));
}

}  // namespace

std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t count = x.size();
  if (count < 2) return std::vector<double>(count, 0.0);
  std::vector<double> secants(count - 1);
  for (std::size_t i = 0; i + 1 < count; ++i) secants[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  std::vector<double> slopes(count);
  slopes.front() = secants.front();
  slopes.back() = secants.back();
  for (std::size_t i = 1; i + 1 < count; ++i) {
    // The harmonic mean of both sides never exceeds what keeps the cubic monotone.
    const double before = secants[i - 1], after = secants[i];
    slopes[i] = before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
  }
  return slopes;
}

Curve::Curve(std::vector<dvec3> points, std::vector<double> times_s, bool constant_speed)
    : points_(std::move(points)), times_(std::move(times_s)) {
  knots_ = {0.0};
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const double way = glm::distance(points_[i - 1], points_[i]);
    knots_.push_back(knots_.back() + std::max(std::sqrt(way), kLeastKnot));
  }
  slopes_ = monotone_slopes(times_, knots_);
  if (constant_speed && points_.size() > 1) measure();
}

void Curve::measure() {
  const std::size_t pieces = kPieces * (points_.size() - 1);
  lengths_ = {0.0};
  dvec3 last = points_.front();
  for (std::size_t i = 1; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(pieces);
    const dvec3 next = at_knot(share * knots_.back());
    lengths_.push_back(lengths_.back() + std::max(glm::distance(last, next), 1e-12));
    last = next;
  }
}

dvec3 Curve::at_knot(double knot) const {
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

double Curve::knot_at(double time_s) const {
  if (!lengths_.empty()) {
    const double share = (time_s - times_.front()) / (times_.back() - times_.front());
    const double length = share * lengths_.back();
    const std::size_t i = piece_of(lengths_, length);
    const double part = (length - lengths_[i]) / (lengths_[i + 1] - lengths_[i]);
    return (static_cast<double>(i) + part) / static_cast<double>(lengths_.size() - 1) *
           knots_.back();
  }
  const std::size_t i = piece_of(times_, time_s);
  const double width = times_[i + 1] - times_[i], t = (time_s - times_[i]) / width;
  const double t2 = t * t, t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * knots_[i] + (t3 - 2.0 * t2 + t) * width * slopes_[i] +
         (3.0 * t2 - 2.0 * t3) * knots_[i + 1] + (t3 - t2) * width * slopes_[i + 1];
}

dvec3 Curve::at(double time_s) const {
  if (points_.size() == 1 || time_s <= times_.front()) return points_.front();
  if (time_s >= times_.back()) return points_.back();
  return at_knot(std::clamp(knot_at(time_s), 0.0, knots_.back()));
}

}  // namespace aerostat::film
