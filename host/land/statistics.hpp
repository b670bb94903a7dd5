#pragma once

#include <cstdint>
#include <vector>

namespace aerostat::land {

/// What stands out in the samples of a raster. Heights are in metres.
struct RasterStatistics {
  std::uint64_t samples = 0;
  std::uint64_t voids = 0;         // samples without a height
  std::uint64_t largest_void = 0;  // about so many samples of the largest connected region of them
  bool void_at_rim = false;        // the largest region reaches the rim of the raster
  std::uint64_t at_zero = 0, below_zero = 0;
  /// The two lowest and the two highest heights that occur, and how often the ends do. If only one
  /// height occurs, the next ones equal it.
  float lowest = 0.0f, next_lowest = 0.0f, next_highest = 0.0f, highest = 0.0f;
  std::uint64_t at_lowest = 0, at_highest = 0;

  std::uint64_t known() const { return samples - voids; }

  /// Counts further samples. NaN are voids.
  void add(const std::vector<float>& heights);

  /// Counts the samples of other statistics, apart from the regions of voids.
  void add(const RasterStatistics& other);
};

/// Returns whether a sea at 0 m is in the samples: much of their area is at 0 m, or some of it is
/// deeper than any dry land.
bool show_sea(const RasterStatistics& statistics);

}  // namespace aerostat::land
