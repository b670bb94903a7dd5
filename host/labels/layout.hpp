#pragma once

#include <string>
#include <vector>

#include "core/math.hpp"

namespace aerostat::labels {

/// A name, and the point in the picture that it belongs to.
struct Point {
  std::string name;
  dvec2 pixel{0.0};
  double height_m = 0.0;  // higher places come first where there is not room for all
};

/// A name with its place in the picture.
struct Label {
  std::string name;
  dvec2 point{0.0};        // where the leader line begins
  dvec2 lo{0.0}, hi{0.0};  // the box of the text
};

/// The height of letters in pixels for a picture of a height in pixels.
double text_size(double picture_height);

/// Puts the names above their points, so that no two boxes overlap, no leader line crosses a box,
/// and all stay within the picture of a size in pixels. Names for which there is no room are left
/// out. The widths of texts are estimates.
std::vector<Label> lay_out(std::vector<Point> points, const dvec2& size);

}  // namespace aerostat::labels
