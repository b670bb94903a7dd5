#include "elevation/raster.hpp"

#include <algorithm>
#include <cstddef>

#include "core/error.hpp"

namespace aerostat::elevation {

void Raster::read_overview(int, const Window&, float*) const {
  throw Error(ErrorKind::internal, info_.path.string() + ": the file has no overviews");
}

std::array<int, 2> Raster::overview_size(int) const {
  throw Error(ErrorKind::internal, info_.path.string() + ": the file has no overviews");
}

MemoryRaster::MemoryRaster(RasterInfo info, std::vector<float> heights)
    : Raster(std::move(info)), heights_(std::move(heights)) {}

void MemoryRaster::read(const Window& window, float* heights) const {
  for (int j = 0; j < window.height; ++j) {
    const std::size_t first =
        static_cast<std::size_t>(window.row + j) * static_cast<std::size_t>(info_.width) +
        static_cast<std::size_t>(window.column);
    std::copy_n(heights_.begin() + static_cast<std::ptrdiff_t>(first), window.width,
                heights + static_cast<std::size_t>(j) * static_cast<std::size_t>(window.width));
  }
}

}  // namespace aerostat::elevation
