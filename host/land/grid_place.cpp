#include "land/grid_place.hpp"

#include "geo/transform.hpp"

namespace aerostat::land {
namespace {

bool is_on_earth(const elevation::Georeference& grid, const LandPoint& middle) {
  return middle.place && !grid.crs.empty();
}

}  // namespace

void local_to_grid(const elevation::Georeference& grid, const LandPoint& middle,
                   std::span<dvec2> points) {
  if (is_on_earth(grid, middle)) {
    geo::Transform(grid.crs, *middle.place).from_local(points);
  } else {
    for (dvec2& point : points) point = {middle.own.x + point.x, middle.own.y - point.y};
  }
  const glm::dmat2 to_place = glm::inverse(glm::dmat2(grid.per_column, grid.per_row));
  for (dvec2& point : points) point = to_place * (point - grid.origin);
}

void grid_to_local(const elevation::Georeference& grid, const LandPoint& middle,
                   std::span<dvec2> places) {
  for (dvec2& place : places) {
    place = grid.origin + place.x * grid.per_column + place.y * grid.per_row;
  }
  if (is_on_earth(grid, middle)) {
    geo::Transform(grid.crs, *middle.place).to_local(places);
  } else {
    for (dvec2& place : places) place = {place.x - middle.own.x, middle.own.y - place.y};
  }
}

}  // namespace aerostat::land
