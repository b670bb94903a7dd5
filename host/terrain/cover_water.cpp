#include "cover_water.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>

#include "core/stop_scope.hpp"
#include "land/grid_walk.hpp"

namespace aerostat::terrain {
namespace {

constexpr int kMostCells = 2048;  // along a side, which bounds the time and the memory
/// Water whose heights differ by less is a lake with one level. Noise of radar data is about as
/// much. Other water is a river, which falls.
constexpr float kLakeSpread_m = 4.0f;
/// Of the heights on a lake, this share is lower than its level: shores that are taken for water
/// are too high.
constexpr double kLevelShare = 0.35;
/// A river is as high as the lowest ground within so many cells, smoothed over as many.
constexpr int kRiverReach = 3, kRiverSmoothings = 6;
constexpr float kSeaTop_m = 1.0f;  // water up to this height is the sea
constexpr float kDry = std::numeric_limits<float>::quiet_NaN();

/// Finds the levels of wet cells.
class Levels {
 public:
  /// `heights` are those of wet cells, and NaN elsewhere.
  Levels(int side, std::vector<float> heights, bool has_sea)
      : side_(static_cast<std::size_t>(side)), heights_(std::move(heights)), has_sea_(has_sea) {
    levels_.assign(heights_.size(), kDry);
    std::vector<std::uint8_t> seen(heights_.size());
    for (std::size_t start = 0; start < heights_.size(); ++start) {
      if (seen[start] != 0 || std::isnan(heights_[start])) continue;
      std::vector<std::size_t> cells{start};
      seen[start] = 1;
      for (std::size_t k = 0; k < cells.size(); ++k) {
        land::visit_neighbours(cells[k], side_, heights_.size(), [&](std::size_t next) {
          if (seen[next] != 0 || std::isnan(heights_[next])) return;
          seen[next] = 1;
          cells.push_back(next);
        });
      }
      set_levels(cells);
    }
  }

  std::vector<float> take() { return std::move(levels_); }

 private:
  /// Sets the levels of connected cells.
  void set_levels(const std::vector<std::size_t>& cells) {
    std::vector<float> sorted;
    for (const std::size_t at : cells) sorted.push_back(heights_[at]);
    std::sort(sorted.begin(), sorted.end());
    const auto at_share = [&sorted](double share) {
      return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    };
    if (has_sea_ && at_share(0.5) <= kSeaTop_m) return;
    if (at_share(0.7) - at_share(0.1) <= kLakeSpread_m) {
      for (const std::size_t at : cells) levels_[at] = at_share(kLevelShare);
      return;
    }
    for (const std::size_t at : cells) levels_[at] = lowest_near(at);
    std::vector<float> smoothed(cells.size());
    for (int round = 0; round < kRiverSmoothings; ++round) {
      for (std::size_t k = 0; k < cells.size(); ++k) smoothed[k] = mean_around(cells[k]);
      for (std::size_t k = 0; k < cells.size(); ++k) levels_[cells[k]] = smoothed[k];
    }
  }

  /// Returns the lowest height of the wet cells around a cell.
  float lowest_near(std::size_t at) const {
    const int i = static_cast<int>(at % side_), j = static_cast<int>(at / side_);
    const int last = static_cast<int>(side_) - 1;
    float lowest = heights_[at];
    for (int v = std::max(j - kRiverReach, 0); v <= std::min(j + kRiverReach, last); ++v)
      for (int u = std::max(i - kRiverReach, 0); u <= std::min(i + kRiverReach, last); ++u) {
        const float height =
            heights_[static_cast<std::size_t>(v) * side_ + static_cast<std::size_t>(u)];
        if (height < lowest) lowest = height;  // no number is not lower
      }
    return lowest;
  }

  /// Returns the mean of the levels of a cell and its neighbours.
  float mean_around(std::size_t at) const {
    float sum = levels_[at], count = 1.0f;
    land::visit_neighbours(at, side_, levels_.size(), [&](std::size_t next) {
      if (std::isnan(levels_[next])) return;
      sum += levels_[next];
      count += 1.0f;
    });
    return sum / count;
  }

  std::size_t side_;
  std::vector<float> heights_, levels_;
  bool has_sea_;
};

}  // namespace

CoverWater::CoverWater(const land::Cover& cover, const land::LocalLand& local, bool has_sea,
                       double reach_m)
    : reach_m_(reach_m), cell_m_(std::max(cover.ground().texel_m, 2.0 * reach_m / kMostCells)) {
  const int side = static_cast<int>(std::ceil(2.0 * reach_m / cell_m_));
  const auto stride = static_cast<std::size_t>(side);
  std::vector<float> heights(stride * stride, kDry);
  tbb::parallel_for(0, side, [&, stop = current_stop()](int j) {
    stop_if_asked(stop);
    std::vector<float> east, south, wet;
    std::vector<std::size_t> cells;
    const double z = (j + 0.5) * cell_m_ - reach_m_;
    for (int i = 0; i < side; ++i) {
      const double x = (i + 0.5) * cell_m_ - reach_m_;
      if (!(cover.water_at(x, z, cell_m_) > 0.5f)) continue;
      cells.push_back(static_cast<std::size_t>(j) * stride + static_cast<std::size_t>(i));
      east.push_back(static_cast<float>(x));
      south.push_back(static_cast<float>(z));
    }
    const std::vector<float> spacing(cells.size(), static_cast<float>(cell_m_));
    std::vector<float> height(cells.size()), slope(cells.size()), other(cells.size());
    local.sample({east, south, spacing, height, slope, other});
    for (std::size_t k = 0; k < cells.size(); ++k) heights[cells[k]] = height[k];
  });
  land::WetCells wet{side, side, 1, Levels(side, std::move(heights), has_sea).take()};
  map_ = std::make_unique<const land::WaterMap>(wet);
}

land::WaterPoint CoverWater::at(double east_m, double south_m, double spacing_m) const {
  land::WaterPoint point = map_->at((east_m + reach_m_) / cell_m_ - 0.5,
                                    (south_m + reach_m_) / cell_m_ - 0.5, spacing_m / cell_m_);
  point.shore *= static_cast<float>(cell_m_);
  return point;
}

}  // namespace aerostat::terrain
