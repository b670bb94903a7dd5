#include "scree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <tbb/parallel_for.h>

#include "core/array.hpp"
#include "core/simd.hpp"

namespace aerostat::terrain {
namespace {

constexpr float kNowhere = -std::numeric_limits<float>::infinity();
constexpr int kReach = 6;             // cells around a wall in which its foot is searched
constexpr float kWallTangent = 1.0f;  // ground steeper than this loses stones

/// Returns the least value within kReach cells along a row or a column.
Array<float> least_along(std::span<const float> values, int stride, bool rows) {
  Array<float> least(values.size());
  tbb::parallel_for(0, stride, [&](int j) {
    float* to = &least[static_cast<std::size_t>(j) * stride];
    std::copy_n(&values[static_cast<std::size_t>(j) * stride], stride, to);
    for (int d = -kReach; d <= kReach; ++d) {
      if (!rows && (j + d < 0 || j + d >= stride)) continue;
      const float* from = &values[static_cast<std::size_t>(rows ? j : j + d) * stride];
      const int begin = rows ? std::max(0, -d) : 0, end = rows ? stride - std::max(0, d) : stride;
      const int shift = rows ? d : 0;
      in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
        for (int i = begin; i < end; ++i) to[i] = std::min(to[i], from[i + shift]);
      });
    }
  });
  return least;
}

/// Returns the heights at which stones come to rest against the walls. They lie at a share of the
/// way up from the foot of the wall. Other places get kNowhere.
Array<float> rest_heights(const GradedHeights& ground, float share) {
  const int stride = ground.stride();
  const Array<float> foot = least_along(least_along(ground.values, stride, true), stride, false);
  Array<float> rest(ground.values.size());
  tbb::parallel_for(0, stride, [&](int j) {
    const std::size_t first = static_cast<std::size_t>(j) * stride;
    std::fill_n(&rest[first], stride, kNowhere);
    if (j == 0 || j + 1 == stride) return;
    const float *here = &ground.values[first], *above = here - stride, *below = here + stride;
    const float across = ground.lines[j + 1] - ground.lines[j - 1];
    const float *lines = ground.lines.data(), *low = &foot[first];
    float* to = &rest[first];
    in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
      for (int i = 1; i + 1 < stride; ++i) {
        const float dx = (here[i + 1] - here[i - 1]) / (lines[i + 1] - lines[i - 1]);
        const float dz = (below[i] - above[i]) / across;
        const float heaped = low[i] + share * (here[i] - low[i]);
        to[i] = dx * dx + dz * dz < kWallTangent * kWallTangent ? kNowhere : heaped;
      }
    });
  });
  return rest;
}

/// Lets the loose surface run out, one row after another, from the rows that it has reached.
/// `step` is +1 to begin at the first row and -1 to begin at the last.
void run_out(const std::vector<float>& lines, Array<float>& loose, int step) {
  const int stride = static_cast<int>(lines.size());
  std::vector<float> along(lines.size(), 0.0f), slants(lines.size()), drops(lines.size());
  for (int i = 1; i < stride; ++i) {
    along[i] = lines[i] - lines[i - 1];
    drops[i] = kScreeTangent * along[i];
  }
  for (int n = 0; n < stride; ++n) {
    const int j = step > 0 ? n : stride - 1 - n;
    float* row = &loose[static_cast<std::size_t>(j) * stride];
    if (n > 0) {
      const float* last = row - step * stride;
      const float across = std::fabs(lines[j] - lines[j - step]);
      in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
        const float drop = kScreeTangent * across;
        for (int i = 1; i < stride; ++i)
          slants[i] = kScreeTangent * std::sqrt(across * across + along[i] * along[i]);
        for (int i = 0; i < stride; ++i) row[i] = std::max(row[i], last[i] - drop);
        for (int i = 1; i < stride; ++i) row[i] = std::max(row[i], last[i - 1] - slants[i]);
        for (int i = 1; i < stride; ++i) row[i - 1] = std::max(row[i - 1], last[i] - slants[i]);
      });
    }
    float reached = row[0];
    for (int i = 1; i < stride; ++i) row[i] = reached = std::max(row[i], reached - drops[i]);
    for (int i = stride - 1; i > 0; --i)
      row[i - 1] = reached = std::max(row[i - 1], reached - drops[i]);
  }
}

}  // namespace

void lay_scree(GradedHeights& ground, float share) {
  if (!(share > 0.0f) || ground.stride() < 3) return;
  Array<float> loose = rest_heights(ground, std::min(share, 1.0f));
  run_out(ground.lines, loose, 1);
  run_out(ground.lines, loose, -1);
  const int stride = ground.stride();
  tbb::parallel_for(0, stride, [&](int j) {
    const std::size_t first = static_cast<std::size_t>(j) * stride;
    for (std::size_t i = first; i < first + static_cast<std::size_t>(stride); ++i)
      ground.values[i] = std::max(ground.values[i], loose[i]);
  });
}

}  // namespace aerostat::terrain
