#pragma once

#include <cstdint>
#include <vector>

namespace aerostat::land {

/// A level area of a raster that is taken as water: a lake, or a reach of a river.
struct FlatWater {
  float level_m = 0.0f;
  std::uint64_t cells = 0;
};

/// The level areas of a raster.
struct FlatWaters {
  std::vector<FlatWater> areas;
  std::vector<float> level_m;  // for each cell that of its area, or NaN; empty if there is no area
};

/// What is known of the heights of a raster.
struct FlatWaterRule {
  float step_m = 0.0f;   // step of which all heights are whole multiples, or 0
  bool has_sea = false;  // heights of 0 m and below are the sea and its floor
};

/// Finds areas of cells with one height, which are how elevation data show lakes and wide rivers.
/// Whole metres make level terraces of gentle land as well. An area is water if
///   - it has at least 40 cells, and a quarter of them lie amidst cells of the same height,
///   - less than an eighth of its shore falls away from it, as land does at the foot of a terrace,
///   - the land around rises: a quarter of the area's half width away, and at least three cells, it
///     is higher by 1.5 steps on the mean. The bottom of a basin of gentle land rises by one step.
/// Cells that share a side are connected. Cells without a height are NaN.
FlatWaters find_flat_water(int width, int height, const std::vector<float>& heights,
                           const FlatWaterRule& rule);

}  // namespace aerostat::land
