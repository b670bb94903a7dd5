#include "land/pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>

#include <tbb/parallel_for.h>

#include "land/fine_tiles.hpp"
#include "land/height_steps.hpp"
#include "land/reduce.hpp"
#include "land/voids.hpp"

namespace aerostat::land {
namespace {

/// The most cells of the finest level in memory.
constexpr std::uint64_t kMostBaseCells = 6'000'000;

std::uint64_t cells_at(const elevation::RasterInfo& info, int level) {
  const auto along = [level](int samples) {
    return (static_cast<std::uint64_t>(samples) + (std::uint64_t{1} << level) - 1) >> level;
  };
  return along(info.width) * along(info.height);
}

/// Returns a level of cells that are twice as wide.
Patch coarser(const Patch& fine) {
  Patch patch;
  patch.width = (fine.width + 1) / 2;
  patch.height = (fine.height + 1) / 2;
  patch.heights = halved(fine.width, fine.height, fine.heights);
  return patch;
}

/// Gives large regions without heights the depth of a sea.
void flood_voids(const VoidRegions& voids, const PyramidOptions& options, int samples_a_cell,
                 std::vector<float>& heights) {
  if (!(options.sea_depth_m > 0.0f)) return;
  const int most = options.most_filled / samples_a_cell;
  for (std::size_t at = 0; at < heights.size(); ++at) {
    if (voids.region_of[at] < 0) continue;
    const VoidRegions::Region& region =
        voids.regions[static_cast<std::size_t>(voids.region_of[at])];
    if (std::max(region.width, region.height) > most) heights[at] = -options.sea_depth_m;
  }
}

}  // namespace

Pyramid::Pyramid(std::shared_ptr<const elevation::Raster> raster, const PyramidOptions& options)
    : raster_(std::move(raster)) {
  while (cells_at(raster_->info(), base_) > kMostBaseCells) ++base_;
  read_base(options);
  while (std::max(levels_.back().width, levels_.back().height) > 1) {
    levels_.push_back(coarser(levels_.back()));
  }
  tbb::parallel_for(std::size_t{0}, levels_.size(), [this](std::size_t k) { levels_[k].fit(); });
  if (base_ == 0) return;
  fine_ = std::make_unique<FineTiles>(*raster_, step_, [this](double column, double row) {
    return level_at(base_, column, row).height;
  });
}

Pyramid::~Pyramid() = default;

void Pyramid::read_base(const PyramidOptions& options) {
  Reduced reduced = reduce(*raster_, base_);
  statistics_ = reduced.statistics;
  step_ = step_of(reduced.some_heights, static_cast<float>(raster_->info().metres_per_unit));
  Patch base;
  base.width = reduced.width;
  base.height = reduced.height;
  base.heights = std::move(reduced.heights);
  if (options.inland_water) find_water(base);
  if (statistics_.voids > 0) {
    const VoidRegions voids = find_voids(base.width, base.height, base.heights);
    known_.resize(base.heights.size());
    for (std::size_t at = 0; at < known_.size(); ++at) known_[at] = voids.region_of[at] < 0;
    for (const VoidRegions::Region& region : voids.regions) {
      const std::uint64_t samples = std::min(region.cells << (2 * base_), statistics_.voids);
      if (samples <= statistics_.largest_void) continue;
      statistics_.largest_void = samples;
      statistics_.void_at_rim = region.at_rim;
    }
    flood_voids(voids, options, 1 << base_, base.heights);
    fill_voids(base.width, base.height, base.heights);
  }
  if (base_ == 0 && step_ > 0.0f) smooth_steps(base.width, base.height, step_, base.heights);
  levels_.push_back(std::move(base));
}

void Pyramid::find_water(const Patch& base) {
  FlatWaters found =
      find_flat_water(base.width, base.height, base.heights, {step_, show_sea(statistics_)});
  if (found.areas.empty()) return;
  water_ = std::make_unique<const WaterMap>(
      WetCells{base.width, base.height, 1 << base_, std::move(found.level_m)});
  flat_waters_ = std::move(found.areas);
}

SplinePoint Pyramid::level_at(int level, double column, double row) const {
  const double cell = std::ldexp(1.0, level);
  const double u = (column + 0.5) / cell - 0.5, v = (row + 0.5) / cell - 0.5;
  SplinePoint point = level < base_ ? fine_->at(level, u, v)
                                    : levels_[static_cast<std::size_t>(level - base_)].at(u, v);
  point.along_columns /= static_cast<float>(cell);
  point.along_rows /= static_cast<float>(cell);
  return point;
}

SplinePoint Pyramid::at(double column, double row, double samples) const {
  const double last_column = raster_->info().width - 1, last_row = raster_->info().height - 1;
  const double outside = std::max({-column, column - last_column, -row, row - last_row, 0.0});
  const double size = std::max(samples, 1.0 + 0.5 * outside);
  const double top = base_ + static_cast<double>(levels_.size()) - 1.0;
  const double level = std::clamp(std::log2(size), 0.0, top);
  const int finer = static_cast<int>(level);
  const auto share = static_cast<float>(level - finer);
  const double held_column = std::clamp(column, 0.0, last_column);
  const double held_row = std::clamp(row, 0.0, last_row);
  SplinePoint point = level_at(finer, held_column, held_row);
  if (share > 0.0f) {
    const SplinePoint coarser = level_at(finer + 1, held_column, held_row);
    point.height += share * (coarser.height - point.height);
    point.along_columns += share * (coarser.along_columns - point.along_columns);
    point.along_rows += share * (coarser.along_rows - point.along_rows);
  }
  return point;
}

bool Pyramid::is_known(double column, double row) const {
  const elevation::RasterInfo& info = raster_->info();
  if (!(column >= -0.5 && column <= info.width - 0.5 && row >= -0.5 && row <= info.height - 0.5)) {
    return false;
  }
  if (known_.empty()) return true;
  const Patch& base = levels_.front();
  const double cell = std::ldexp(1.0, base_);
  const int i = std::clamp(static_cast<int>((column + 0.5) / cell), 0, base.width - 1);
  const int j = std::clamp(static_cast<int>((row + 0.5) / cell), 0, base.height - 1);
  return known_[static_cast<std::size_t>(j) * static_cast<std::size_t>(base.width) +
                static_cast<std::size_t>(i)] != 0;
}

}  // namespace aerostat::land
