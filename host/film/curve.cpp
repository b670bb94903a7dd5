#include "film/curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aerostat::film {
namespace {

/// Pieces of the curve's length between two points. At 200, the speed of a sharp bend is even to
/// within a thousandth (measured in the test).
constexpr std::size_t kPieces = 200;

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
    : curve_(std::move(points)), times_(std::move(times_s)) {
  slopes_ = monotone_slopes(times_, curve_.knots());
  if (constant_speed && curve_.points().size() > 1) measure();
}

void Curve::measure() {
  const std::size_t pieces = kPieces * (curve_.points().size() - 1);
  lengths_ = {0.0};
  dvec3 last = curve_.points().front();
  for (std::size_t i = 1; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(pieces);
    const dvec3 next = curve_.at(share * curve_.knots().back());
    lengths_.push_back(lengths_.back() + std::max(glm::distance(last, next), 1e-12));
    last = next;
  }
}

double Curve::knot_at(double time_s) const {
  const std::vector<double>& knots = curve_.knots();
  if (!lengths_.empty()) {
    const double share = (time_s - times_.front()) / (times_.back() - times_.front());
    const double length = share * lengths_.back();
    const std::size_t i = piece_of(lengths_, length);
    const double part = (length - lengths_[i]) / (lengths_[i + 1] - lengths_[i]);
    return (static_cast<double>(i) + part) / static_cast<double>(lengths_.size() - 1) *
           knots.back();
  }
  const std::size_t i = piece_of(times_, time_s);
  const double width = times_[i + 1] - times_[i], t = (time_s - times_[i]) / width;
  const double t2 = t * t, t3 = t2 * t;
  return (2.0 * t3 - 3.0 * t2 + 1.0) * knots[i] + (t3 - 2.0 * t2 + t) * width * slopes_[i] +
         (3.0 * t2 - 2.0 * t3) * knots[i + 1] + (t3 - t2) * width * slopes_[i + 1];
}

dvec3 Curve::at(double time_s) const {
  const std::vector<dvec3>& points = curve_.points();
  if (points.size() == 1 || time_s <= times_.front()) return points.front();
  if (time_s >= times_.back()) return points.back();
  return curve_.at(std::clamp(knot_at(time_s), 0.0, curve_.knots().back()));
}

}  // namespace aerostat::film
