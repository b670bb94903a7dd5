#pragma once

#include <vector>

namespace aerostat::terrain {

/// Heights on the crossings of grid lines, row by row; x and z share their lines, which ascend.
struct GradedHeights {
  std::vector<float> lines;  // metres
  std::vector<float> values;

  int stride() const { return static_cast<int>(lines.size()); }
};

/// Tangent of the angle at which broken rock comes to rest, 35 degrees.
inline constexpr float kScreeTangent = 0.7f;

/// Thermal slumping, as its end: what frost breaks off the walls lies at their feet, in cones and
/// aprons at the angle of repose. Wherever this raises the ground it lies loose, and from there no
/// neighbour, of eight, is lower by more than kScreeTangent times its distance (within rounding).
/// Nothing is lowered. Aprons climb to `share` (0 to 1) of the height of the wall above them within
/// some cells. Stones run out one row after another, on one core; the rest is done on all.
void lay_scree(GradedHeights& ground, float share);

}  // namespace aerostat::terrain
