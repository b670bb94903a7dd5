#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "elevation/raster.hpp"
#include "land/flat_water.hpp"
#include "land/statistics.hpp"
#include "land/water_map.hpp"

/// The heights of one raster in levels of detail, ready to be sampled anywhere.
namespace aerostat::land {

/// A height and its slope along columns and rows, in metres per sample of the raster.
struct SplinePoint {
  float height = 0.0f, along_columns = 0.0f, along_rows = 0.0f;
};

/// A rectangle of cells of a level with a cubic B-spline through their heights.
struct Patch {
  int column = 0, row = 0;      // cell of the level that comes first
  int width = 0, height = 0;    // cells
  std::vector<float> heights;   // row by row, without voids
  std::vector<float> controls;  // the spline's control values

  /// Returns the spline at a place counted in cells of the level, from the middle of its first
  /// cell. The height is held within the range of the 4 x 4 cells around the place, so that it
  /// never overshoots. Slopes are per cell of the level. Beyond the patch, its rim counts.
  SplinePoint at(double u, double v) const;

  /// Works out the control values from the heights.
  void fit();
};

class FineTiles;

struct PyramidOptions {
  /// Large regions without heights become a sea of this depth in metres; 0: land goes on.
  float sea_depth_m = 0.0f;
  /// Regions of at most so many samples across are always filled as land.
  int most_filled = 64;
  /// Whether level areas are lakes and rivers.
  bool inland_water = true;
};

/// Levels of detail. A cell of level k is the mean of 2^k x 2^k samples. Levels from a base on, of
/// at most some million cells, are in memory. Cells of the levels below are read when they are
/// asked for, so that a huge raster costs what a picture needs of it. Voids are filled smoothly
/// from the cells around them by averages of ever larger cells ("push and pull"), and whole steps
/// of heights, such as whole metres, are smoothed within half a step. It may be used from any
/// thread.
class Pyramid {
 public:
  Pyramid(std::shared_ptr<const elevation::Raster> raster, const PyramidOptions& options);
  ~Pyramid();

  const RasterStatistics& statistics() const { return statistics_; }
  const elevation::Raster& raster() const { return *raster_; }
  /// Returns the step of which all heights are whole multiples, such as a metre, or 0.
  float step() const { return step_; }

  /// Returns the height at a column and row of the raster, as fine as cells of `samples` samples a
  /// side. Beyond the raster, the land goes on and turns ever smoother.
  SplinePoint at(double column, double row, double samples) const;

  /// Number of the first level in memory, whose cells tell where water is.
  int base_level() const { return base_; }

  /// The lakes and reaches of rivers that were found.
  const std::vector<FlatWater>& flat_waters() const { return flat_waters_; }

  /// Where they lie, or null if there are none.
  const WaterMap* water() const { return water_.get(); }

  /// Returns whether there is a height in the file near a place, and not one that was filled in.
  bool is_known(double column, double row) const;

 private:
  SplinePoint level_at(int level, double column, double row) const;
  void read_base(const PyramidOptions& options);
  void find_water(const Patch& base);

  std::shared_ptr<const elevation::Raster> raster_;
  RasterStatistics statistics_;
  float step_ = 0.0f;
  int base_ = 0;                     // number of the first level in memory
  std::vector<Patch> levels_;        // from the base on
  std::vector<std::uint8_t> known_;  // cells of the base that have a height in the file; empty: all
  std::unique_ptr<FineTiles> fine_;
  std::vector<FlatWater> flat_waters_;
  std::unique_ptr<const WaterMap> water_;
};

}  // namespace aerostat::land
