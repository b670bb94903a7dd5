#pragma once

#include <vector>

#include "scene/balloon.hpp"

namespace aerostat::scene {

/// Returns the albedos of a palette's fabrics, in linear Rec. 709, in the order in which a
/// pattern repeats them.
std::vector<vec3> palette_colors(Palette palette);

/// Returns a palette for the i-th of several balloons, so that neighbours differ.
Palette palette_of_place(std::size_t i);

/// Sets the palette of the balloon and the colours of that palette.
void dress(Balloon& balloon, Palette palette);

}  // namespace aerostat::scene
