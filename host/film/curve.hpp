#pragma once

#include <cstddef>
#include <vector>

#include "core/math.hpp"
#include "core/smooth_curve.hpp"

namespace aerostat::film {

/// A smooth curve through points, by time. The way along it follows the times of the points by a
/// monotone cubic (F. N. Fritsch and R. E. Carlson, "Monotone piecewise cubic interpolation",
/// 1980), so that the speed has no jumps and nothing ever goes back.
class Curve {
 public:
  /// Takes points with rising times, one or more. With `constant_speed`, only the first and the
  /// last time count.
  Curve(std::vector<dvec3> points, std::vector<double> times_s, bool constant_speed);

  /// Returns the point at a time. Before the first time and after the last one, the curve rests.
  dvec3 at(double time_s) const;

 private:
  double knot_at(double time_s) const;
  void measure();

  SmoothCurve curve_;
  std::vector<double> times_, slopes_;
  std::vector<double> lengths_;  // from the start to even steps of the knots; empty: by times
};

/// Returns the slopes of the monotone cubic through points with rising `x` and rising `y`.
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace aerostat::film
