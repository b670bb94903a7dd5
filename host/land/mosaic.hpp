#pragma once

#include <memory>
#include <vector>

#include "elevation/raster.hpp"

namespace aerostat::land {

using RasterPointer = std::shared_ptr<const elevation::Raster>;

/// Joins rasters that lie on one grid, such as neighbouring tiles, so that nothing is seen of their
/// seams. Where they overlap, the first that has a height wins. Rasters on other grids form rasters
/// of their own, in the order of their first members.
std::vector<RasterPointer> joined(const std::vector<RasterPointer>& rasters);

}  // namespace aerostat::land
