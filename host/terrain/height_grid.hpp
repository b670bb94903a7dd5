#pragma once

#include <vector>

#include "points.hpp"

namespace aerostat::terrain {

/// Values on a square grid around the origin. Node (i, j) lies at (x(i), x(j)).
struct HeightGrid {
  int nodes = 0;  // nodes along a side
  float spacing_m = 1.0f;
  std::vector<float> values;  // row by row, with rising z

  float x(int i) const {
    return (static_cast<float>(i) - 0.5f * static_cast<float>(nodes - 1)) * spacing_m;
  }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(nodes) +
           static_cast<std::size_t>(i);
  }
};

/// Makes a grid with the given number of nodes along a side that covers a square of `size_m`. All
/// values are 0.
HeightGrid make_grid(int nodes, double size_m);

/// Evaluates a uniform cubic B-spline through the grid's control values. It has continuous
/// curvature and stays in the range of the values. Outside the grid, the nearest value at the rim
/// counts. dx and dz are its derivatives.
void sample(const HeightGrid& grid, const Points& points, Block& value, Block& dx, Block& dz);

/// Returns control values whose spline comes closer to the values of `grid`, so that it rounds
/// off crests less. They may leave the range of the values.
HeightGrid sharpen(const HeightGrid& grid);

/// Returns the values at twice the resolution, with 2 n - 1 nodes along a side.
HeightGrid refine(const HeightGrid& grid);

}  // namespace aerostat::terrain
