#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "core/math.hpp"

namespace aerostat::film {

/// The ways of the balloons of a film, which are compared at moments 0.1 s apart, or, in long
/// films, a 2000th of the film apart.
class Traffic {
 public:
  /// The places of a balloon at these moments, with heights above the sea.
  using Way = std::vector<dvec3>;

  explicit Traffic(double duration_s);

  Way way_of(const std::function<dvec3(double time_s)>& place) const;

  void add(Way way) { ways_.push_back(std::move(way)); }

  /// Returns how near a way comes to those that were added. Without any, it is infinite.
  double least_distance(const Way& way) const;

 private:
  double step_s_;
  int steps_;
  std::vector<Way> ways_;
};

}  // namespace aerostat::film
