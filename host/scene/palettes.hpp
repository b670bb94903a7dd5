#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace aerostat::scene {

/// The fabrics of a palette: albedo, linear Rec. 709, in the order in which a pattern repeats them.
std::vector<vec3> palette_colors(Palette palette);

/// One for the i-th of several balloons, so that neighbours differ.
Palette palette_of_place(std::size_t i);

/// Chooses what the balloons wear: `palette`, and its colours.
void dress(Balloon& balloon, Palette palette);

}  // namespace aerostat::scene
