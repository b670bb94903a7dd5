#pragma once

#include <cstdint>
#include <vector>

#include "core/math.hpp"

namespace aerostat::land {

/// Water at a place of a raster.
struct WaterPoint {
  float shore = 0.0f;    // distance from the shore in samples: positive on water, negative on land
  float level_m = 0.0f;  // height of the nearest water, or NaN if none is near
};

/// Cells of a raster under water.
struct WetCells {
  int width = 0, height = 0;
  int samples_a_cell = 1;      // along a side
  std::vector<float> level_m;  // for each cell the height of its water, or NaN on land
};

/// Lakes and rivers of a raster in levels of detail. The shore is a smooth line between the cells
/// of the two sides, and levels that meet, as those of a river's reaches, pass into one another.
/// Land far from water costs neither memory nor time. It never changes and may be used from any
/// thread.
class WaterMap {
 public:
  explicit WaterMap(const WetCells& cells);

  /// Returns the water at a column and row of the raster, without detail that is finer than
  /// `samples` samples. There is none beyond the raster.
  WaterPoint at(double column, double row, double samples) const;

  /// Returns whether water may be known anywhere between two columns and two rows of the raster.
  bool is_near(const dvec2& least, const dvec2& most) const;

 private:
  struct Layer {
    int width = 0, height = 0;
    std::vector<float> shore;    // distance from the shore in cells of the first layer
    std::vector<float> level_m;  // NaN far from water
  };

  /// A rectangle of cells with the water inside of it. It is wider than the water.
  struct Part {
    int column = 0, row = 0;    // its first cell
    std::vector<Layer> layers;  // cells of each are twice as wide as those of the one before
  };

  static Layer first_layer(const WetCells& cells);
  static Layer coarser(const Layer& fine);
  WaterPoint layer_at(const Part& part, std::size_t number, double column, double row) const;

  /// Returns the tile that holds a column or row of the raster, the nearest one beyond its rim.
  int tile_of(double place, int tiles) const;

  int samples_a_cell_, width_, height_;  // width and height of the raster in samples
  int tiles_across_ = 0, tiles_down_ = 0;
  std::vector<std::int32_t> part_of_;  // for each tile the part that it belongs to, or -1
  std::vector<Part> parts_;
};

}  // namespace aerostat::land
