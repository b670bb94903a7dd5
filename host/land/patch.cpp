#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/cubic_spline.hpp"
#include "land/pyramid.hpp"

namespace aerostat::land {
namespace {

/// Weights that can be numbered.
std::array<float, 4> listed(const SplineWeights& weights) {
  return {weights.w0, weights.w1, weights.w2, weights.w3};
}

/// Returns the cell that stands for one beyond the rim, as in a mirror at the middle of the cells
/// of the rim.
int mirrored(int cell, int count) {
  if (count == 1) return 0;
  const int period = 2 * (count - 1);
  const int wrapped = ((cell % period) + period) % period;
  return wrapped < count ? wrapped : period - wrapped;
}

/// The four cells around a place along one axis.
struct Around {
  std::array<int, 4> cells;
  std::array<float, 4> weights, slopes;
};

Around around(double place, int count) {
  const double held = std::clamp(place, 0.0, static_cast<double>(count - 1));
  const int cell = std::min(static_cast<int>(held), std::max(count - 2, 0));
  const auto share = static_cast<float>(held - cell);
  Around found{{}, listed(spline_weights(share)), listed(spline_slope_weights(share))};
  for (int k = 0; k < 4; ++k) found.cells[k] = mirrored(cell + k - 1, count);
  return found;
}

// The pole of the filter that turns samples into the control values of the interpolating cubic
// B-spline. Source: M. Unser, A. Aldroubi, M. Eden, "B-spline signal processing: part II" (1993).
constexpr float kPole = -0.26794919f;  // sqrt(3) - 2
constexpr int kTerms = 16;             // kPole^16 is below what single precision can hold

/// Turns values into control values, `count` groups of `lanes` values each.
void prefilter(float* values, int count, std::size_t stride, int lanes) {
  if (count < 2) return;
  const auto group = [&](int k) { return values + static_cast<std::size_t>(k) * stride; };
  std::vector<float> start(static_cast<std::size_t>(lanes), 0.0f);
  float power = 1.0f;
  for (int k = 0; k < kTerms; ++k, power *= kPole) {
    const float* from = group(mirrored(k, count));
    for (int i = 0; i < lanes; ++i) start[i] += power * from[i];
  }
  std::copy(start.begin(), start.end(), values);
  for (int k = 1; k < count; ++k) {
    float *here = group(k), *before = group(k - 1);
    for (int i = 0; i < lanes; ++i) here[i] += kPole * before[i];
  }
  float *last = group(count - 1), *next_to_last = group(count - 2);
  for (int i = 0; i < lanes; ++i) {
    last[i] = kPole / (kPole * kPole - 1.0f) * (last[i] + kPole * next_to_last[i]);
  }
  for (int k = count - 2; k >= 0; --k) {
    float *here = group(k), *after = group(k + 1);
    for (int i = 0; i < lanes; ++i) here[i] = kPole * (after[i] - here[i]);
  }
  for (int k = 0; k < count; ++k) {
    float* here = group(k);
    for (int i = 0; i < lanes; ++i) here[i] *= 6.0f;
  }
}

}  // namespace

SplinePoint Patch::at(double u, double v) const {
  const Around x = around(u, width), z = around(v, height);
  SplinePoint point;
  float lowest = heights[0], highest = heights[0];
  for (int j = 0; j < 4; ++j) {
    const std::size_t row_start =
        static_cast<std::size_t>(z.cells[j]) * static_cast<std::size_t>(width);
    float value = 0.0f, slope = 0.0f;
    for (int i = 0; i < 4; ++i) {
      const std::size_t cell = row_start + static_cast<std::size_t>(x.cells[i]);
      const float known = heights[cell];
      lowest = i + j == 0 ? known : std::min(lowest, known);
      highest = i + j == 0 ? known : std::max(highest, known);
      value += x.weights[i] * controls[cell];
      slope += x.slopes[i] * controls[cell];
    }
    point.height += z.weights[j] * value;
    point.along_columns += z.weights[j] * slope;
    point.along_rows += z.slopes[j] * value;
  }
  point.height = std::clamp(point.height, lowest, highest);
  return point;
}

void Patch::fit() {
  controls = heights;
  // Rows are filtered one by one, and columns many at a time, because these lie beside one another.
  static constexpr int kColumns = 256;
  tbb::parallel_for(tbb::blocked_range<int>(0, height, 16), [this](const auto& rows) {
    for (int j = rows.begin(); j != rows.end(); ++j) {
      prefilter(controls.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(width),
                width, 1, 1);
    }
  });
  tbb::parallel_for(0, (width + kColumns - 1) / kColumns, [this](int block) {
    const int first = block * kColumns;
    prefilter(controls.data() + first, height, static_cast<std::size_t>(width),
              std::min(kColumns, width - first));
  });
}

}  // namespace aerostat::land
