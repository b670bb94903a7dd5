#pragma once

#include <vector>

#include "elevation/raster.hpp"
#include "land/statistics.hpp"

namespace aerostat::land {

/// A raster whose samples were averaged.
struct Reduced {
  int width = 0, height = 0;
  std::vector<float> heights;  // means of the samples that have a height, else NaN
  RasterStatistics statistics;
  std::vector<float> some_heights;  // single samples from all over the raster
};

/// Reads a whole raster and averages 2^level x 2^level samples to one cell. It starts from an
/// overview of the file if that has at least twice the resolution of the cells; then the statistics
/// are those of the overview. Memory is that of the result and of some rows. All cores are used.
Reduced reduce(const elevation::Raster& raster, int level);

/// Returns the means of the cells of a window. It counts in cells of 2^level samples and must begin
/// in the raster.
std::vector<float> reduced_window(const elevation::Raster& raster, int level,
                                  const elevation::Window& cells);

/// Returns the means of 2 x 2 cells, without those that are NaN. At the last row and column of odd
/// sizes, cells are averaged as far as there are any.
std::vector<float> halved(int width, int height, const std::vector<float>& heights);

}  // namespace aerostat::land
