#include "land/flat_water.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "land/grid_walk.hpp"

namespace aerostat::land {
namespace {

// What tells water from terraces. The numbers were chosen by eye with SRTM, NED and lidar data.
constexpr std::size_t kFewestCells = 40;
constexpr double kInnerShare = 0.25;     // of cells amidst cells of the same height
constexpr double kFallingShare = 0.125;  // of the shore that falls away from the area
constexpr double kRiseSteps = 1.5;       // of the land around
constexpr double kLeastRise_m = 0.3;     // of the land around where heights have no step
constexpr int kNearestRing = 3, kFarthestRing = 40;  // cells from the shore to the land around
/// Heights without a step that differ by less are the same. Changing the projection of a raster
/// rounds them.
constexpr float kSame_m = 0.005f;
constexpr float kNoLevel = std::numeric_limits<float>::quiet_NaN();

class FlatWaterFinder {
 public:
  FlatWaterFinder(int width, int height, const std::vector<float>& heights,
                  const FlatWaterRule& rule)
      : width_(static_cast<std::size_t>(width)),
        rows_(height),
        heights_(heights),
        rule_(rule),
        same_m_(rule.step_m > 0.0f ? 0.01f * rule.step_m : kSame_m) {}

  FlatWaters run() {
    find_inner_cells();
    seen_.assign(heights_.size(), 0);
    for (std::size_t start = 0; start < heights_.size(); ++start) {
      if (inner_[start] == 0) continue;
      if (rule_.has_sea && heights_[start] <= 0.0f) continue;
      grow(start);
      if (is_water()) keep();
      forget();
    }
    return std::move(found_);
  }

 private:
  bool same(float a, float b) const { return std::abs(a - b) <= same_m_; }

  /// Marks the cells whose eight neighbours have their height.
  void find_inner_cells() {
    inner_.assign(heights_.size(), 0);
    tbb::parallel_for(
        tbb::blocked_range<int>(1, std::max(rows_ - 1, 1), 16), [&](const auto& rows) {
          for (int j = rows.begin(); j != rows.end(); ++j)
            for (std::size_t i = 1; i + 1 < width_; ++i) {
              const std::size_t at = static_cast<std::size_t>(j) * width_ + i;
              const float* here = heights_.data() + at;
              // Without branches, this is done for many cells at once.
              int level = 1;
              for (const std::size_t step : {std::size_t{1}, width_ - 1, width_, width_ + 1}) {
                level &= static_cast<int>(same(here[step], *here)) &
                         static_cast<int>(same(*(here - step), *here));
              }
              inner_[at] = static_cast<std::uint8_t>(level);
            }
        });
  }

  /// Collects the area around a cell, and what its shore is like.
  void grow(std::size_t start) {
    level_ = heights_[start];
    area_.assign(1, start);
    seen_[start] = 1;
    shore_.clear();
    rings_.clear();
    inner_count_ = falling_ = rising_ = 0;
    for (std::size_t k = 0; k < area_.size(); ++k) {
      inner_count_ += inner_[area_[k]];
      inner_[area_[k]] = 0;  // the area is looked at once
      visit_neighbours(area_[k], width_, heights_.size(), [&](std::size_t next) {
        if (seen_[next] != 0) return;
        if (same(heights_[next], level_)) {
          seen_[next] = 1;
          area_.push_back(next);
        } else if (!std::isnan(heights_[next])) {
          ++(heights_[next] < level_ ? falling_ : rising_);
          shore_.push_back(next);
        }
      });
    }
  }

  bool is_water() {
    const auto cells = static_cast<double>(area_.size());
    const auto shore = static_cast<double>(falling_ + rising_);
    if (area_.size() < kFewestCells || static_cast<double>(inner_count_) < kInnerShare * cells) {
      return false;
    }
    if (rising_ == 0 || static_cast<double>(falling_) > kFallingShare * shore) return false;
    const double half_width = 2.0 * cells / shore;
    const int ring = std::clamp(static_cast<int>(0.25 * half_width), kNearestRing, kFarthestRing);
    const double least = rule_.step_m > 0.0f ? kRiseSteps * rule_.step_m : kLeastRise_m;
    return rise_around(ring) >= least;
  }

  /// Returns how much higher than the area the cells `ring` cells from it are on the mean.
  double rise_around(int ring) {
    for (int k = 1; k < ring; ++k) {
      next_shore_.clear();
      for (const std::size_t at : shore_) {
        if (seen_[at] != 0) continue;
        seen_[at] = 1;
        rings_.push_back(at);
        visit_neighbours(at, width_, heights_.size(), [&](std::size_t next) {
          if (seen_[next] == 0 && !std::isnan(heights_[next])) next_shore_.push_back(next);
        });
      }
      shore_.swap(next_shore_);
    }
    double sum = 0.0, count = 0.0;
    for (const std::size_t at : shore_) {
      if (seen_[at] != 0) continue;
      sum += static_cast<double>(heights_[at]) - static_cast<double>(level_);
      count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
  }

  void keep() {
    if (found_.level_m.empty()) found_.level_m.assign(heights_.size(), kNoLevel);
    for (const std::size_t at : area_) found_.level_m[at] = level_;
    found_.areas.push_back({level_, area_.size()});
  }

  /// Makes all cells unseen again.
  void forget() {
    for (const auto* cells : {&area_, &rings_})
      for (const std::size_t at : *cells) seen_[at] = 0;
  }

  std::size_t width_;
  int rows_;
  const std::vector<float>& heights_;
  FlatWaterRule rule_;
  float same_m_;
  FlatWaters found_;
  std::vector<std::uint8_t> inner_;
  // The area that is looked at.
  std::vector<std::uint8_t> seen_;  // cells that belong to it or to the rings around it
  float level_ = 0.0f;
  std::vector<std::size_t> area_, rings_, shore_, next_shore_;
  std::size_t inner_count_ = 0, falling_ = 0, rising_ = 0;
};

}  // namespace

FlatWaters find_flat_water(int width, int height, const std::vector<float>& heights,
                           const FlatWaterRule& rule) {
  return FlatWaterFinder(width, height, heights, rule).run();
}

}  // namespace aerostat::land
