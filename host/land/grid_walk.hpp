#pragma once

#include <cstddef>

namespace aerostat::land {

/// Calls `visit` with each of the up to four cells that share a side with a cell of a grid whose
/// rows are `width` cells long and which has `cells` cells in all.
template <class Visit>
void visit_neighbours(std::size_t at, std::size_t width, std::size_t cells, Visit&& visit) {
  const std::size_t column = at % width;
  if (column > 0) visit(at - 1);
  if (column + 1 < width) visit(at + 1);
  if (at >= width) visit(at - width);
  if (at + width < cells) visit(at + width);
}

}  // namespace aerostat::land
