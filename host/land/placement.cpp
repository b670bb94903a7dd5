#include "land/placement.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::land {
namespace {

constexpr int kPointsAnEdge = 17;

}  // namespace

Placement::Placement(const elevation::RasterInfo& info, const LandPoint& middle,
                     const OverlayWords& words)
    : info_(info), grid_(*info_.georeference), middle_(middle) {
  if (middle.place && grid_.crs.empty()) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: the {} does not say its coordinate reference system; {} names it",
                            info_.path.string(), words.what, words.crs_option));
  }
  if (!middle.place) return;
  transform_.emplace(grid_.crs, *middle.place);
  if (!geo::crs_info(grid_.crs).geographic) return;
  // Longitudes may count from 0 to 360 degrees in the raster.
  const double centre = grid_.origin.x + 0.5 * info_.width * grid_.per_column.x +
                        0.5 * info_.height * grid_.per_row.x;
  shift_.x = 360.0 * std::round((centre - middle.place->longitude_deg) / 360.0);
}

void Placement::to_raster(std::vector<dvec2>& points) const {
  if (transform_) {
    transform_->from_local(points);
  } else {
    for (dvec2& p : points) p = {middle_.own.x + p.x, middle_.own.y - p.y};
  }
  const glm::dmat2 inverse = glm::inverse(glm::dmat2(grid_.per_column, grid_.per_row));
  for (dvec2& p : points) {
    p = inverse * (p + shift_ - grid_.origin) + 0.5;
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) p = dvec2(-1e8);
    p = glm::clamp(p, dvec2(-1e8), dvec2(1e8));
  }
}

std::pair<dvec2, dvec2> Placement::bounds() const {
  std::vector<dvec2> points;
  for (int j = 0; j < kPointsAnEdge; ++j) {
    for (int i = 0; i < kPointsAnEdge; ++i) {
      const double column = info_.width * static_cast<double>(i) / (kPointsAnEdge - 1) - 0.5;
      const double row = info_.height * static_cast<double>(j) / (kPointsAnEdge - 1) - 0.5;
      points.push_back(grid_.origin + column * grid_.per_column + row * grid_.per_row - shift_);
    }
  }
  if (transform_) {
    transform_->to_local(points);
  } else {
    for (dvec2& p : points) p = {p.x - middle_.own.x, middle_.own.y - p.y};
  }
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::pair<dvec2, dvec2> box{dvec2(kFar), dvec2(-kFar)};
  for (const dvec2& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    box.first = glm::min(box.first, p);
    box.second = glm::max(box.second, p);
  }
  return box;
}

double Placement::sample_m(const dvec2& at) const {
  std::vector<dvec2> points{at, at + dvec2(1.0, 0.0), at + dvec2(0.0, 1.0)};
  to_raster(points);
  const dvec2 a = points[1] - points[0], b = points[2] - points[0];
  const double area = std::abs(a.x * b.y - a.y * b.x);
  return area > 0.0 ? 1.0 / std::sqrt(area) : 0.0;
}

}  // namespace aerostat::land
