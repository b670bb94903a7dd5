#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "elevation/raster.hpp"
#include "land/pyramid.hpp"

namespace aerostat::land {

/// Squares of the levels of a raster that are too large for memory. They are read when they are
/// first asked for, and those that were read last are kept. It may be used from any thread.
class FineTiles {
 public:
  /// The height of the ground by a coarser level at a column and row of the raster, which fills
  /// voids.
  using Coarser = std::function<float(double column, double row)>;

  /// `step` is that of smooth_steps, or 0. The raster must live as long as this object.
  FineTiles(const elevation::Raster& raster, float step, Coarser coarser);

  /// Returns the spline of a level at a place counted in its cells from the middle of the first
  /// one.
  SplinePoint at(int level, double u, double v) const;

 private:
  struct Slot {
    std::once_flag once;
    std::shared_ptr<const Patch> patch;
  };

  std::shared_ptr<const Patch> tile(int level, int column, int row) const;
  std::shared_ptr<const Patch> read(int level, int column, int row) const;

  const elevation::Raster& raster_;
  float step_;
  Coarser coarser_;
  mutable std::mutex mutex_;
  mutable std::unordered_map<std::uint64_t, std::shared_ptr<Slot>> slots_;
};

}  // namespace aerostat::land
