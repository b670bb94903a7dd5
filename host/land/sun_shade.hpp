#pragma once

#include <memory>
#include <vector>

#include "core/math.hpp"
#include "land/land.hpp"

namespace aerostat::land {

/// Heights and slopes of a square of land at the nodes of a grid.
struct ReliefGrid {
  int side = 0;         // nodes along a side
  double step_m = 1.0;  // between nodes
  dvec2 middle{0.0};    // of the square, in metres to the east and to the south
  std::vector<float> height_m, slope_east, slope_south;  // row by row from the north-west
  float highest_m = 0.0f;

  /// Samples land with `side` nodes along the side of a square. Detail is not finer than `cell_m`
  /// metres.
  ReliefGrid(const LocalLand& land, const dvec2& middle, double side_m, int side, double cell_m);
};

/// The light of a sun on land relative to that on level ground: 0 where mountains cast their
/// shadow and on slopes that face away from the sun, and more than 1 on slopes that face it.
class SunShade {
 public:
  /// Computes the light at the nodes of a grid. Shadows are cast by what lies within the grid.
  SunShade(const ReliefGrid& relief, double azimuth_deg, double elevation_deg);

  /// Returns the light at the nodes, row by row.
  const std::vector<float>& nodes() const { return light_; }

  /// Returns the light at a point, between the four nodes around it.
  float at(const dvec2& point) const;

 private:
  float shadow(const ReliefGrid& relief, int column, int row, const dvec2& towards,
               double rise) const;

  int side_;
  double step_m_;
  dvec2 middle_;
  std::vector<float> light_;
};

}  // namespace aerostat::land
