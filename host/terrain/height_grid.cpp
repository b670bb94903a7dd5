#include "height_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/parallel_for.h>

namespace aerostat::terrain {
namespace {

using Weights = std::array<float, 4>;

Weights spline(float t) {
  const float s = 1.0f - t;
  return {s * s * s / 6.0f, (3.0f * t * t * t - 6.0f * t * t + 4.0f) / 6.0f,
          (3.0f * s * s * s - 6.0f * s * s + 4.0f) / 6.0f, t * t * t / 6.0f};
}

Weights spline_slope(float t) {
  const float s = 1.0f - t;
  return {-0.5f * s * s, 1.5f * t * t - 2.0f * t, -1.5f * s * s + 2.0f * s, 0.5f * t * t};
}

struct Position {
  int cell;
  float fraction;
};

Position locate(const HeightGrid& grid, float metres) {
  const auto last = static_cast<float>(grid.nodes - 1);
  const float p = std::clamp(metres / grid.spacing_m + 0.5f * last, 0.0f, last);
  const int cell = std::min(static_cast<int>(p), grid.nodes - 2);
  return {cell, p - static_cast<float>(cell)};
}

}  // namespace

HeightGrid make_grid(int nodes, double size_m) {
  HeightGrid grid;
  grid.nodes = nodes;
  grid.spacing_m = static_cast<float>(size_m / (nodes - 1));
  grid.values.assign(static_cast<std::size_t>(nodes) * static_cast<std::size_t>(nodes), 0.0f);
  return grid;
}

void sample(const HeightGrid& grid, const Points& points, Block& value, Block& dx, Block& dz) {
  const int last = grid.nodes - 1;
  for (int k = 0; k < points.count; ++k) {
    const Position px = locate(grid, points.x[k]);
    const Position pz = locate(grid, points.z[k]);
    const Weights wx = spline(px.fraction);
    const Weights wz = spline(pz.fraction);
    const Weights dwx = spline_slope(px.fraction);
    const Weights dwz = spline_slope(pz.fraction);
    float h = 0.0f;
    float along_x = 0.0f;
    float along_z = 0.0f;
    for (int j = 0; j < 4; ++j) {
      const float* row = &grid.values[grid.index(0, std::clamp(pz.cell + j - 1, 0, last))];
      float sum = 0.0f;
      float slope_sum = 0.0f;
      for (int i = 0; i < 4; ++i) {
        const float v = row[std::clamp(px.cell + i - 1, 0, last)];
        sum += wx[i] * v;
        slope_sum += dwx[i] * v;
      }
      h += wz[j] * sum;
      along_x += wz[j] * slope_sum;
      along_z += dwz[j] * sum;
    }
    value[k] = h;
    dx[k] = along_x / grid.spacing_m;
    dz[k] = along_z / grid.spacing_m;
  }
}

HeightGrid sharpen(const HeightGrid& grid) {
  // One step of iteration towards the interpolating spline: what the spline takes off a node is
  // added to it.
  HeightGrid sharp = grid;
  const int last = grid.nodes - 1;
  tbb::parallel_for(0, grid.nodes, [&](int j) {
    const int j0 = std::max(j - 1, 0), j1 = std::min(j + 1, last);
    for (int i = 0; i < grid.nodes; ++i) {
      const int i0 = std::max(i - 1, 0), i1 = std::min(i + 1, last);
      const auto row = [&](int k) {
        return grid.values[grid.index(i0, k)] + 4.0f * grid.values[grid.index(i, k)] +
               grid.values[grid.index(i1, k)];
      };
      const float blurred = (row(j0) + 4.0f * row(j) + row(j1)) / 36.0f;
      sharp.values[grid.index(i, j)] += grid.values[grid.index(i, j)] - blurred;
    }
  });
  return sharp;
}

HeightGrid refine(const HeightGrid& grid) {
  HeightGrid fine;
  fine.nodes = 2 * grid.nodes - 1;
  fine.spacing_m = 0.5f * grid.spacing_m;
  fine.values.resize(static_cast<std::size_t>(fine.nodes) * static_cast<std::size_t>(fine.nodes));
  for (int j = 0; j < fine.nodes; ++j)
    for (int i = 0; i < fine.nodes; ++i) {
      const int i0 = i / 2;
      const int j0 = j / 2;
      const int i1 = i0 + i % 2;
      const int j1 = j0 + j % 2;
      fine.values[fine.index(i, j)] =
          0.25f * (grid.values[grid.index(i0, j0)] + grid.values[grid.index(i1, j0)] +
                   grid.values[grid.index(i0, j1)] + grid.values[grid.index(i1, j1)]);
    }
  return fine;
}

}  // namespace aerostat::terrain
