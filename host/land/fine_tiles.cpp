#include "land/fine_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tbb/task_arena.h>

#include "land/height_steps.hpp"
#include "land/reduce.hpp"

namespace aerostat::land {
namespace {

constexpr int kTile = 256;  // cells along a side
// Cells around a tile that are read with it. The smoothing of steps reaches so far that
// neighbouring tiles agree to some centimetres.
constexpr int kHalo = 40;
constexpr std::size_t kMostTiles = 600;  // some 540 MiB

std::uint64_t key_of(int level, int column, int row) {
  return (static_cast<std::uint64_t>(level) << 56) | (static_cast<std::uint64_t>(column) << 28) |
         static_cast<std::uint64_t>(row);
}

/// Returns how many cells of a level lie along `samples` samples.
int cells_along(int samples, int level) {
  return (samples + (1 << level) - 1) >> level;
}

}  // namespace

FineTiles::FineTiles(const elevation::Raster& raster, float step, Coarser coarser)
    : raster_(raster), step_(step), coarser_(std::move(coarser)) {}

SplinePoint FineTiles::at(int level, double u, double v) const {
  const int columns = cells_along(raster_.info().width, level);
  const int rows = cells_along(raster_.info().height, level);
  const int column = static_cast<int>(std::clamp(u, 0.0, columns - 1.0)) / kTile;
  const int row = static_cast<int>(std::clamp(v, 0.0, rows - 1.0)) / kTile;
  // Neighbouring points mostly lie in the same tile.
  struct Last {
    const FineTiles* tiles = nullptr;
    std::uint64_t key = 0;
    std::weak_ptr<const Patch> patch;
  };
  thread_local Last last;
  const std::uint64_t key = key_of(level, column, row);
  std::shared_ptr<const Patch> patch;
  if (last.tiles == this && last.key == key) patch = last.patch.lock();
  if (!patch) {
    patch = tile(level, column, row);
    last = {this, key, patch};
  }
  return patch->at(u - patch->column, v - patch->row);
}

std::shared_ptr<const Patch> FineTiles::tile(int level, int column, int row) const {
  std::shared_ptr<Slot> slot;
  {
    const std::lock_guard lock(mutex_);
    if (slots_.size() >= kMostTiles) slots_.clear();
    std::shared_ptr<Slot>& found = slots_[key_of(level, column, row)];
    if (!found) found = std::make_shared<Slot>();
    slot = found;
  }
  std::call_once(slot->once, [&] {
    // A thread that waits for its own loops must not take up another task, which could wait for
    // this very tile.
    tbb::this_task_arena::isolate([&] { slot->patch = read(level, column, row); });
  });
  return slot->patch;
}

std::shared_ptr<const Patch> FineTiles::read(int level, int column, int row) const {
  const auto patch = std::make_shared<Patch>();
  const int columns = cells_along(raster_.info().width, level);
  const int rows = cells_along(raster_.info().height, level);
  patch->column = std::max(column * kTile - kHalo, 0);
  patch->row = std::max(row * kTile - kHalo, 0);
  patch->width = std::min((column + 1) * kTile + kHalo, columns) - patch->column;
  patch->height = std::min((row + 1) * kTile + kHalo, rows) - patch->row;
  patch->heights =
      reduced_window(raster_, level, {patch->column, patch->row, patch->width, patch->height});
  const double cell = std::ldexp(1.0, level);
  std::size_t at = 0;
  for (int j = 0; j < patch->height; ++j)
    for (int i = 0; i < patch->width; ++i, ++at) {
      if (!std::isnan(patch->heights[at])) continue;
      patch->heights[at] =
          coarser_((patch->column + i + 0.5) * cell - 0.5, (patch->row + j + 0.5) * cell - 0.5);
    }
  if (level == 0 && step_ > 0.0f) {
    smooth_steps(patch->width, patch->height, step_, patch->heights);
  }
  patch->fit();
  return patch;
}

}  // namespace aerostat::land
