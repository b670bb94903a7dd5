#pragma once

#include <cstdint>
#include <vector>

#include "core/math.hpp"
#include "scene_params.h"

namespace aerostat::pack {

/// Returns the cell of the cube of stars that a direction lies in (kernels: star_cell).
std::uint32_t star_cell(const dvec3& direction);

/// Sorts stars into the cells into which their blurs of the radius `reach` extend, and appends them
/// and the starts of the cells to the buffer of the sky. Writes to `numbers` where they lie there.
void append_stars(const std::vector<AeroStar>& stars, double reach, AeroStars& numbers,
                  std::vector<AeroSkyCell>& sky_table);

}  // namespace aerostat::pack
