#pragma once

#include <span>

#include "scene_params.h"

namespace aerostat::pack {

/// Returns the probabilities by which paths look for light in the directions of the sky. They are
/// in proportion to the light of each cell of the sky's table, with a lower limit. Below the
/// horizon they are small, because land hides most of it. Under clouds that the table does not hold
/// they are more even.
AeroSkyImportance sky_importance(const AeroScene& numbers, std::span<const AeroSkyCell> table);

}  // namespace aerostat::pack
