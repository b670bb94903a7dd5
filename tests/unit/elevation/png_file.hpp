#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace aerostat::elevation {

/// Returns a PNG file. `colour` is PNG's type of colour (0 grey, 2 RGB, 4 grey and opacity, 6 RGB
/// and opacity), and `values` holds the samples row by row.
std::string png(int width, int height, int bits, int colour, const std::vector<int>& values);

}  // namespace aerostat::elevation
