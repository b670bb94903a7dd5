#pragma once

#include <vector>

#include "core/math.hpp"

namespace aerostat::pack {

/// A star of the catalogue.
struct Star {
  dvec3 direction{0.0};  // unit vector in the frame of the equator of 2000, z to the north pole
  double magnitude = 0.0;
  double color_index = 0.0;  // B-V
};

/// Returns the 5044 stars down to visual magnitude 6.0, the brightest first. Directions are right
/// to 0.006 degrees, magnitudes to 0.02 and B-V to 0.01. Source: the Hipparcos catalogue (ESA
/// SP-1200, 1997) as compiled in XHIP (E. Anderson and C. Francis, "XHIP: An extended Hipparcos
/// compilation", Astronomy Letters 38, 2012).
const std::vector<Star>& star_catalogue();

/// Returns the colour of a star by its B-V, whose luminance is that of white. It is that of a black
/// body beside a sun of 5800 K, which is white. Source of the temperature: F. J. Ballesteros, "New
/// insights into black bodies", EPL 97 (2012).
dvec3 star_hue(double color_index);

}  // namespace aerostat::pack
