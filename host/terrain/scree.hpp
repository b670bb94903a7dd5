#pragma once

#include <vector>

namespace aerostat::terrain {

/// Heights on the crossings of grid lines, row by row. x and z have the same ascending lines.
struct GradedHeights {
  std::vector<float> lines;  // coordinates in metres
  std::vector<float> values;

  int stride() const { return static_cast<int>(lines.size()); }
};

/// The tangent of 35 degrees, the angle at which broken rock comes to rest.
inline constexpr float kScreeTangent = 0.7f;

/// Adds the end state of thermal slumping. Rock that frost breaks off the walls lies at their
/// feet, in cones and aprons at the angle of repose. No ground is lowered. Raised ground is
/// loose, and none of its eight neighbours is lower by more than kScreeTangent times its distance
/// (within rounding). Aprons climb to `share` (0 to 1) of the height of the wall above them
/// within some cells. Stones run out one row after another, on one core. All other work uses all
/// cores.
void lay_scree(GradedHeights& ground, float share);

}  // namespace aerostat::terrain
