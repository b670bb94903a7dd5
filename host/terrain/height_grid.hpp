#pragma once

#include <vector>

#include "points.hpp"

namespace aerostat::terrain {

/// Values on a square grid around the origin, node (i, j) at (origin + i, origin + j) * spacing.
struct HeightGrid {
  int nodes = 0;  // per side
  float spacing_m = 1.0f;
  std::vector<float> values;  // row by row, z outwards

  float x(int i) const {
    return (static_cast<float>(i) - 0.5f * static_cast<float>(nodes - 1)) * spacing_m;
  }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(nodes) +
           static_cast<std::size_t>(i);
  }
};

/// A grid of the given number of nodes that covers a square of `size_m`; values are 0.
HeightGrid make_grid(int nodes, double size_m);

/// Uniform cubic B-spline through the grid's control values: continuous curvature, never beyond
/// the range of the values. Outside the grid the nearest rim counts. dx and dz are its derivatives.
void sample(const HeightGrid& grid, const Points& points, Block& value, Block& dx, Block& dz);

/// Control values whose spline comes closer to `grid`'s values: it rounds off crests less. May
/// leave their range.
HeightGrid sharpen(const HeightGrid& grid);

/// The values at twice the resolution: 2 n - 1 nodes per side.
HeightGrid refine(const HeightGrid& grid);

}  // namespace aerostat::terrain
