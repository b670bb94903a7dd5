#pragma once

#include <cstddef>
#include <vector>

#include "core/math.hpp"
#include "scatter/scatter.hpp"

namespace aerostat::scatter {

/// Many circles in plan, with an index that finds those around a point.
class Circles {
 public:
  void add(const KeepOut& circle) { circles_.push_back(circle); }
  /// Builds the index for `hold` with reaches up to `most_reach_m`. Call it when all circles are
  /// added.
  void index(double most_reach_m = 0.0);
  /// Returns whether a point lies within a circle, or nearer to one than `reach_m`.
  bool hold(const dvec2& point, double reach_m = 0.0) const;

 private:
  std::vector<KeepOut> circles_;
  /// A grid of squares from `least_` on. The circles that reach into square number i are those of
  /// `members_` from first_[i] to first_[i + 1].
  dvec2 least_{0.0};
  double square_m_ = 1.0;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::size_t> first_, members_;
};

}  // namespace aerostat::scatter
