#pragma once

#include <cstdint>
#include <vector>

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
/// of the two sides, and levels that meet, as those of a river's reaches, pass into one another. It
/// never changes and may be used from any thread.
class WaterMap {
 public:
  explicit WaterMap(const WetCells& cells);

  /// Returns the water at a column and row of the raster, without detail that is finer than
  /// `samples` samples. There is none beyond the raster.
  WaterPoint at(double column, double row, double samples) const;

 private:
  struct Layer {
    int width = 0, height = 0;
    std::vector<float> shore;    // distance from the shore in cells of the first layer
    std::vector<float> level_m;  // NaN far from water
  };

  static Layer first_layer(const WetCells& cells);
  static Layer coarser(const Layer& fine);
  WaterPoint layer_at(std::size_t number, double column, double row) const;

  int samples_a_cell_, width_, height_;  // width and height of the raster in samples
  std::vector<Layer> layers_;  // cells of each are twice as wide as those of the one before
};

}  // namespace aerostat::land
