#include "land/height_steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace aerostat::land {
namespace {

// Wide strides come first, so that also long terraces become slopes. The numbers are chosen by eye.
constexpr int kStrides[] = {16, 8, 4, 2, 1};
constexpr int kRounds = 4;

/// Moves every height half of the way to the mean of the neighbours at a distance, within half a
/// step of the rounded heights.
void smooth_once(int width, int height, int stride, float half_step,
                 const std::vector<float>& rounded, const std::vector<float>& from,
                 std::vector<float>& to) {
  const auto row = [width](const std::vector<float>& values, int j) {
    return values.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(width);
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, height, 16), [&](const auto& rows) {
    for (int j = rows.begin(); j != rows.end(); ++j) {
      const float* here = row(from, j);
      const float* north = row(from, std::max(j - stride, 0));
      const float* south = row(from, std::min(j + stride, height - 1));
      const float* target = row(rounded, j);
      float* out = to.data() + (here - from.data());
      const auto smooth = [&](int i, int west, int east) {
        const float mean = 0.25f * (here[west] + here[east] + north[i] + south[i]);
        const float value = 0.5f * (here[i] + mean);
        out[i] = std::clamp(value, target[i] - half_step, target[i] + half_step);
      };
      const int end = std::max(width - stride, std::min(stride, width));
      for (int i = 0; i < std::min(stride, width); ++i)
        smooth(i, std::max(i - stride, 0), std::min(i + stride, width - 1));
      for (int i = std::min(stride, width); i < end; ++i) smooth(i, i - stride, i + stride);
      for (int i = end; i < width; ++i)
        smooth(i, std::max(i - stride, 0), std::min(i + stride, width - 1));
    }
  });
}

bool all_multiples(const std::vector<float>& heights, double step) {
  return std::all_of(heights.begin(), heights.end(), [step](float height) {
    if (std::isnan(height)) return true;
    const double steps = height / step;
    // A height in single precision can be off by half of its last bit.
    return std::abs(steps - std::round(steps)) <= 1e-6 * std::abs(steps) + 1e-4;
  });
}

}  // namespace

float step_of(const std::vector<float>& heights, float unit_m) {
  for (const double share : {1.0, 0.5, 0.1}) {
    const double step = share * unit_m;
    if (step >= 0.05 && all_multiples(heights, step)) return static_cast<float>(step);
  }
  return 0.0f;
}

void smooth_steps(int width, int height, float step, std::vector<float>& heights) {
  const std::vector<float> rounded = heights;
  std::vector<float> other(heights.size());
  for (const int stride : kStrides) {
    for (int round = 0; round < kRounds; ++round) {
      smooth_once(width, height, stride, 0.5f * step, rounded, heights, other);
      heights.swap(other);
    }
  }
}

}  // namespace aerostat::land
