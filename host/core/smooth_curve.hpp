#pragma once

#include <cstddef>
#include <vector>

#include "core/math.hpp"

namespace aerostat {

/// A smooth curve through points: the centripetal Catmull-Rom spline (P. J. Barry and R. N.
/// Goldman, "A recursive evaluation algorithm for a class of Catmull-Rom splines", SIGGRAPH 1988;
/// C. Yuksel, S. Schaefer and J. Keyser, "Parameterization and applications of Catmull-Rom
/// curves", 2011), which makes neither loops nor cusps between two points. Along the curve counts
/// a knot, which grows by the square root of the distance from point to point.
class SmoothCurve {
 public:
  /// Takes one or more points.
  explicit SmoothCurve(std::vector<dvec3> points);

  const std::vector<dvec3>& points() const { return points_; }
  /// The knots of the points, which rise from 0.
  const std::vector<double>& knots() const { return knots_; }

  /// Returns the point at a knot between that of the first and that of the last point.
  dvec3 at(double knot) const;

 private:
  std::vector<dvec3> points_;
  std::vector<double> knots_;
};

/// Returns the index of the piece of two or more rising values that holds `x`, or of the nearest
/// piece. The piece i reaches from value i to value i + 1.
std::size_t piece_of(const std::vector<double>& values, double x);

}  // namespace aerostat
