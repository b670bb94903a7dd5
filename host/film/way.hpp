#pragma once

#include <string>

#include "film/timeline.hpp"

namespace aerostat::film {

/// Returns a table of the way of the first balloon in a film, in about ten rows: time, place,
/// height above the sea and above the ground, and the wind there. Each line has a line end.
std::string way_text(Timeline& timeline);

}  // namespace aerostat::film
