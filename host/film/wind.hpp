#pragma once

#include <functional>
#include <vector>

#include "core/math.hpp"
#include "scene/film.hpp"

namespace aerostat::film {

/// Returns the velocity of the air at a height above the sea along x and z, in metres per second.
/// Between two layers it changes evenly, and beyond the lowest and the highest one it stays.
/// Without layers the air is still.
dvec2 wind_at(const std::vector<scene::WindLayer>& layers, double height_m);

/// The way of something that the wind carries along, by time. The steps of the sum are fixed, so
/// that a place depends on its time alone.
class Drift {
 public:
  /// Returns the height above the sea at a time.
  using Height = std::function<double(double time_s)>;

  Drift(std::vector<scene::WindLayer> layers, Height height);

  /// Returns how far the wind has carried it from the start along x and z, for a time >= 0.
  dvec2 at(double time_s);

 private:
  dvec2 velocity(double time_s) const;

  std::vector<scene::WindLayer> layers_;
  Height height_;
  std::vector<dvec2> ways_{dvec2(0.0)};  // after each step
};

/// Follows a place that moves, softly: its distance shrinks to the e-th part within a lag. The
/// steps are fixed, so that a place depends on its time alone.
class Chase {
 public:
  /// Returns the place that is followed at a time.
  using Place = std::function<dvec3(double time_s)>;

  Chase(Place place, double lag_s);

  /// Returns where the follower is at a time >= 0. At 0 it is at the place itself.
  dvec3 at(double time_s);

 private:
  Place place_;
  double lag_s_;
  std::vector<dvec3> steps_;
};

}  // namespace aerostat::film
