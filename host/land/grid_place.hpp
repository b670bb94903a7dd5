#pragma once

#include <span>

#include "core/math.hpp"
#include "elevation/raster.hpp"
#include "land/land.hpp"

/// These functions turn places in the grid of a raster into points of a local frame, and back. A
/// place counts columns and rows, and whole numbers are the centres of samples. Points are metres
/// to the east and to the south of `middle`.
namespace aerostat::land {

/// Turns points of the local frame into places. Points without a place become NaN. Throws the
/// errors of geo::Transform.
void local_to_grid(const elevation::Georeference& grid, const LandPoint& middle,
                   std::span<dvec2> points);

/// Turns places into points of the local frame, with the same errors.
void grid_to_local(const elevation::Georeference& grid, const LandPoint& middle,
                   std::span<dvec2> places);

}  // namespace aerostat::land
