#include "land/voids.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "land/grid_walk.hpp"
#include "land/reduce.hpp"

namespace aerostat::land {
namespace {

constexpr int kSmoothings = 12;  // chosen by eye

std::size_t cells_of(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// Returns the value between the middles of coarse cells at the middle of a cell of half their
/// size.
float between(const std::vector<float>& coarse, int width, int height, int i, int j) {
  const auto ends = [](int at, int count) {
    const int here = at / 2;
    return std::pair(here, std::clamp(at % 2 == 0 ? here - 1 : here + 1, 0, count - 1));
  };
  const auto [i0, i1] = ends(i, width);
  const auto [j0, j1] = ends(j, height);
  const auto value = [&](int u, int v) {
    return coarse[cells_of(width, v) + static_cast<std::size_t>(u)];
  };
  return 0.5625f * value(i0, j0) + 0.1875f * (value(i1, j0) + value(i0, j1)) +
         0.0625f * value(i1, j1);
}

/// Lets the filled cells relax towards the mean of their neighbours.
void relax(int width, int height, const std::vector<std::size_t>& filled,
           std::vector<float>& heights) {
  std::vector<float> relaxed(filled.size());
  const auto last_column = static_cast<std::size_t>(width - 1);
  const auto stride = static_cast<std::size_t>(width);
  for (int round = 0; round < kSmoothings; ++round) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, filled.size(), 4096),
                      [&](const auto& range) {
                        for (std::size_t k = range.begin(); k != range.end(); ++k) {
                          const std::size_t at = filled[k], i = at % stride, j = at / stride;
                          const float west = heights[i > 0 ? at - 1 : at];
                          const float east = heights[i < last_column ? at + 1 : at];
                          const float north = heights[j > 0 ? at - stride : at];
                          const float south =
                              heights[j + 1 < static_cast<std::size_t>(height) ? at + stride : at];
                          relaxed[k] = 0.25f * (west + east + north + south);
                        }
                      });
    for (std::size_t k = 0; k < filled.size(); ++k) heights[filled[k]] = relaxed[k];
  }
}

}  // namespace

VoidRegions find_voids(int width, int height, const std::vector<float>& heights) {
  VoidRegions found;
  found.region_of.assign(heights.size(), -1);
  const auto stride = static_cast<std::size_t>(width);
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < heights.size(); ++start) {
    if (!std::isnan(heights[start]) || found.region_of[start] >= 0) continue;
    const auto number = static_cast<std::int32_t>(found.regions.size());
    VoidRegions::Region region;
    std::size_t west = stride, east = 0, north = heights.size(), south = 0;
    const auto enter = [&](std::size_t at) {
      if (!std::isnan(heights[at]) || found.region_of[at] >= 0) return;
      found.region_of[at] = number;
      open.push_back(at);
    };
    enter(start);
    while (!open.empty()) {
      const std::size_t at = open.back(), i = at % stride, j = at / stride;
      open.pop_back();
      ++region.cells;
      west = std::min(west, i), east = std::max(east, i);
      north = std::min(north, j), south = std::max(south, j);
      visit_neighbours(at, stride, heights.size(), enter);
    }
    region.width = static_cast<int>(east - west) + 1;
    region.height = static_cast<int>(south - north) + 1;
    region.at_rim = west == 0 || north == 0 || east + 1 == stride ||
                    south + 1 == static_cast<std::size_t>(height);
    found.regions.push_back(region);
  }
  return found;
}

void fill_voids(int width, int height, std::vector<float>& heights) {
  std::vector<std::size_t> filled;
  for (std::size_t at = 0; at < heights.size(); ++at) {
    if (std::isnan(heights[at])) filled.push_back(at);
  }
  if (filled.empty()) return;
  if (width == 1 && height == 1) {
    heights[0] = 0.0f;
    return;
  }
  const int w = (width + 1) / 2, h = (height + 1) / 2;
  std::vector<float> coarse = halved(width, height, heights);
  fill_voids(w, h, coarse);
  const auto stride = static_cast<std::size_t>(width);
  for (const std::size_t at : filled) {
    heights[at] =
        between(coarse, w, h, static_cast<int>(at % stride), static_cast<int>(at / stride));
  }
  relax(width, height, filled, heights);
}

}  // namespace aerostat::land
