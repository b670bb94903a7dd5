#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "elevation/raster.hpp"

/// Rasters in memory for tests.
namespace aerostat::land {

inline constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

/// Makes a raster on a grid of 10 m whose first sample is at (0, 0), from a function of column and
/// row.
inline std::shared_ptr<elevation::MemoryRaster> make_raster(
    int width, int height, const std::function<double(int, int)>& height_at,
    dvec2 origin = dvec2(0.0), double cell_m = 10.0) {
  elevation::RasterInfo info;
  info.path = "test.tif";
  info.width = width;
  info.height = height;
  info.georeference = {"", origin, {cell_m, 0.0}, {0.0, -cell_m}};
  std::vector<float> heights;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) heights.push_back(static_cast<float>(height_at(i, j)));
  return std::make_shared<elevation::MemoryRaster>(std::move(info), std::move(heights));
}

}  // namespace aerostat::land
