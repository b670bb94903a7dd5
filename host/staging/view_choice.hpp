#pragma once

#include <vector>

#include "core/math.hpp"
#include "staging/view_map.hpp"

namespace aerostat::staging {

/// A place for the balloon and a direction to look in.
struct ViewChoice {
  dvec2 place{0.0};  // x and z of the balloon over the map
  double above_ground_m = 0.0;
  double azimuth_deg = 0.0;  // of the view
  /// The azimuth of the highest part of the skyline, relative to the view; positive to the right.
  double peak_turn_deg = 0.0;
  double score = 0.0;
};

/// Places over a map, x and z.
using ViewPlaces = std::vector<dvec2>;

/// Chooses at most `count` views, the best one first. They differ from one another in place or
/// direction.
///
/// The measure of a view is a sum over rays that fan out over 44 degrees from a height over the
/// balloon's place that is a third of the relief within 8 km:
///   height:  the mean angle of the skyline above the eye, at most 12 degrees, divided by 6
///   shape:   the standard deviation of that angle along the skyline, at most 3 degrees, divided
///   by 2.5 depth:   the mean number of ridges that show one behind the other, at most 4, divided
///   by 4 light:   0.7 times the squared sine of the angle between the view and the sun's azimuth
///   ground:  0.4 where the ground before the blocking distance lies well below the eye
///   far:     0.5 where the skyline is farther than one and a half times the blocking distance
///   summit:  0.5 if the highest point of the map is in sight within the fan
/// less 3 times the share of rays that a slope nearer than the blocking distance blocks, which
/// is 2.5 km, or a quarter of half the map's side if that is less, and all of it times the square
/// of the share of the way to the skyline over which the files have heights. The weights were
/// chosen by eye.
///
/// Places come from a lattice over the map, unless `places` names some.
std::vector<ViewChoice> choose_views(const ViewMap& map, double sun_azimuth_deg, int count,
                                     const ViewPlaces& places = {});

}  // namespace aerostat::staging
