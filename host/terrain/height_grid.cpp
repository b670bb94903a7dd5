#include "height_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <tbb/parallel_for.h>

#include "core/cubic_spline.hpp"
#include "core/simd.hpp"

namespace aerostat::terrain {
namespace {

/// The place of a point along one axis, and the nodes of the four control values there.
struct Position {
  std::int32_t n0, n1, n2, n3;
  float fraction;
};

AEROSTAT_INLINE Position locate(int nodes, float spacing_m, float metres) {
  const std::int32_t last = nodes - 1;
  const auto end = static_cast<float>(last);
  const float p = std::clamp(metres / spacing_m + 0.5f * end, 0.0f, end);
  const std::int32_t cell = std::min(static_cast<std::int32_t>(p), last - 1);
  return {std::max(cell - 1, 0), cell, cell + 1, std::min(cell + 2, last),
          p - static_cast<float>(cell)};
}

/// The value and slope of the spline along x at one of the four rows.
struct Along {
  float value, slope;
};

AEROSTAT_INLINE Along along(const float* values, std::int32_t row, const Position& x,
                            const SplineWeights& w, const SplineWeights& dw) {
  const float v0 = values[row + x.n0], v1 = values[row + x.n1], v2 = values[row + x.n2],
              v3 = values[row + x.n3];
  return {0.0f + w.w0 * v0 + w.w1 * v1 + w.w2 * v2 + w.w3 * v3,
          0.0f + dw.w0 * v0 + dw.w1 * v1 + dw.w2 * v2 + dw.w3 * v3};
}

/// The values that sample() computes.
struct Sampled {
  Block value, dx, dz;
};

AEROSTAT_INLINE void sample_loop(const HeightGrid& grid, const Points& points, Sampled& out) {
  const int nodes = grid.nodes, count = points.count;
  const float spacing_m = grid.spacing_m;
  const float* values = grid.values.data();
  for (int k = 0; k < count; ++k) {
    const Position px = locate(nodes, spacing_m, points.x[k]);
    const Position pz = locate(nodes, spacing_m, points.z[k]);
    const SplineWeights wx = spline_weights(px.fraction), wz = spline_weights(pz.fraction);
    const SplineWeights dwx = spline_slope_weights(px.fraction),
                        dwz = spline_slope_weights(pz.fraction);
    // The calls are written out because compilers do not vectorise a loop within this one.
    const Along r0 = along(values, pz.n0 * nodes, px, wx, dwx);
    const Along r1 = along(values, pz.n1 * nodes, px, wx, dwx);
    const Along r2 = along(values, pz.n2 * nodes, px, wx, dwx);
    const Along r3 = along(values, pz.n3 * nodes, px, wx, dwx);
    out.value[k] = 0.0f + wz.w0 * r0.value + wz.w1 * r1.value + wz.w2 * r2.value + wz.w3 * r3.value;
    const float dx =
        0.0f + wz.w0 * r0.slope + wz.w1 * r1.slope + wz.w2 * r2.slope + wz.w3 * r3.slope;
    const float dz =
        0.0f + dwz.w0 * r0.value + dwz.w1 * r1.value + dwz.w2 * r2.value + dwz.w3 * r3.value;
    out.dx[k] = dx / spacing_m;
    out.dz[k] = dz / spacing_m;
  }
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
  Sampled all;
  in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
    // The results are written to a local object, so that compilers see that no store changes the
    // grid.
    Sampled out;
    sample_loop(grid, points, out);
    all = out;
  });
  std::copy_n(all.value.begin(), points.count, value.begin());
  std::copy_n(all.dx.begin(), points.count, dx.begin());
  std::copy_n(all.dz.begin(), points.count, dz.begin());
}

HeightGrid sharpen(const HeightGrid& grid) {
  // This is one step of iteration towards the interpolating spline. The amount that the spline
  // takes off a node is added to it.
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
