#pragma once

#include <cstdint>
#include <vector>

namespace aerostat::land {

/// The connected regions of cells without a height.
struct VoidRegions {
  std::vector<std::int32_t> region_of;  // for each cell its region, or -1 for a cell with a height
  struct Region {
    std::uint64_t cells = 0;
    bool at_rim = false;
    int width = 0, height = 0;  // of the rectangle around it, in cells
  };
  std::vector<Region> regions;
};

/// Finds the regions of cells that are NaN. Cells that share a side are connected.
VoidRegions find_voids(int width, int height, const std::vector<float>& heights);

/// Fills all cells that are NaN smoothly from the cells around them. Averages over ever larger
/// cells reach into them, and are then refined and smoothed down to single cells. The result stays
/// within the range of the known heights. The time is linear in the number of cells. If no cell has
/// a height, all become 0.
void fill_voids(int width, int height, std::vector<float>& heights);

}  // namespace aerostat::land
