#pragma once

#include <functional>
#include <vector>

#include "core/math.hpp"
#include "film/movers.hpp"
#include "scene/land.hpp"

namespace aerostat::film {

/// Something that moves through the air, and the radius around it in which nothing grows.
struct Flyer {
  dvec3 place{0.0};  // with its height above the sea
  double room_m = 0.0;
};

/// Returns the circles that cover the ways of what flies lower above the ground than plants grow,
/// each with its room around it. Single pictures leave that room around each place alone, so that
/// without these circles plants vanish and come back in a film. `flyers_at` returns all that flies
/// at a time, always in the same order. It is asked in even steps from 0 to `duration_s`, of 0.1 s
/// or, in long films, of a 2000th of the film; between them, everything goes straight.
std::vector<scene::Clearing> clearings_along(
    const std::function<std::vector<Flyer>(double time_s)>& flyers_at, double duration_s,
    const HeightAt& ground);

}  // namespace aerostat::film
