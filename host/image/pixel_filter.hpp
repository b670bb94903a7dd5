#pragma once

#include "core/math.hpp"
#include "image/film.hpp"

namespace aerostat::image {

/// Filters the radiance, the alpha and the guides of a film in place. Each pixel becomes the
/// weighted mean of the 3 x 3 pixels around it, by the weights (side, 1 - 2 side, side) along both
/// axes. Pixels beyond the film have no weight. `side` is 0 to 1/3.
void filter_pixels(Film& film, float side);

/// Removes all pixels of a film that lie outside of a rectangle. The corners of the rectangle are
/// pixels of the whole picture; `end` is the first pixel beyond it.
void cut_to(Film& film, const glm::ivec2& first, const glm::ivec2& end);

}  // namespace aerostat::image
