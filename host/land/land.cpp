#include "land/land.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "geo/transform.hpp"
#include "land/land_notes.hpp"
#include "land/source_files.hpp"

namespace aerostat::land {
namespace {

/// Returns the middle of a raster in its own coordinates.
dvec2 middle_of(const elevation::RasterInfo& info) {
  const elevation::Georeference& grid = *info.georeference;
  return grid.origin + 0.5 * (info.width - 1) * grid.per_column +
         0.5 * (info.height - 1) * grid.per_row;
}

std::vector<RasterPointer> open_all(const LandOptions& options) {
  const std::vector<std::filesystem::path> files = source_files(options.sources);
  std::vector<RasterPointer> rasters(files.size());
  tbb::parallel_for(std::size_t{0}, files.size(),
                    [&](std::size_t k) { rasters[k] = elevation::open(files[k], options.open); });
  return rasters;
}

void require_place(const elevation::RasterInfo& info) {
  if (info.georeference) return;
  throw Error(ErrorKind::bad_data,
              fmt::format("{}: the file does not say where its samples lie; give their distance in "
                          "metres by /terrain/cell_m",
                          info.path.string()));
}

/// Refuses numbers that look like degrees where nothing says what they are.
void require_metres(const elevation::RasterInfo& info) {
  const elevation::Georeference& grid = *info.georeference;
  if (!grid.crs.empty()) return;
  const dvec2 middle = middle_of(info);
  const double cell = std::max(glm::length(grid.per_column), glm::length(grid.per_row));
  if (std::abs(middle.x) > 360.0 || std::abs(middle.y) > 90.0 || cell > 0.2) return;
  throw Error(
      ErrorKind::bad_data,
      fmt::format("{}: the file names no coordinate reference system, and its numbers could be "
                  "degrees (the middle is at {:.4f}, {:.4f}, samples are {:.6g} apart); name the "
                  "system by /terrain/crs, such as EPSG:4326 for degrees",
                  info.path.string(), middle.x, middle.y, cell));
}

}  // namespace

Land::Land(const LandOptions& options) {
  std::vector<RasterPointer> rasters = open_all(options);
  for (const RasterPointer& raster : rasters) {
    require_place(raster->info());
    require_metres(raster->info());
    files_.push_back(raster->info());
    if (raster->info().georeference->crs.empty() == files_[0].georeference->crs.empty()) continue;
    throw Error(
        ErrorKind::bad_data,
        fmt::format(
            "{} names a coordinate reference system, and {} names none; name one for "
            "all files by /terrain/crs",
            (raster->info().georeference->crs.empty() ? files_[0] : files_.back()).path.string(),
            (raster->info().georeference->crs.empty() ? files_.back() : files_[0]).path.string()));
  }
  has_place_ = !files_[0].georeference->crs.empty();
  PyramidOptions pyramid;
  pyramid.sea_depth_m = options.sea_depth_m;
  pyramid.inland_water = options.inland_water;
  for (RasterPointer& raster : joined(rasters)) {
    pyramids_.push_back(std::make_unique<Pyramid>(std::move(raster), pyramid));
  }
  find_extent();
  find_sea();
  notes_ = notes_about(*this);
}

Land::~Land() = default;

void Land::find_extent() {
  const elevation::RasterInfo& first = pyramids_[0]->raster().info();
  const elevation::Georeference& grid = *first.georeference;
  middle_.own = middle_of(first);
  if (has_place_) middle_.place = geo::place_of(grid.crs, middle_.own);
  dvec2 least(std::numeric_limits<double>::infinity()), most(-least);
  for (const auto& pyramid : pyramids_) {
    const elevation::RasterInfo& info = pyramid->raster().info();
    const elevation::Georeference& own = *info.georeference;
    std::array<dvec2, 7> points;
    for (int k = 0; k < 4; ++k) {
      points[k] = own.origin + (k % 2 == 0 ? -0.5 : info.width - 0.5) * own.per_column +
                  (k < 2 ? -0.5 : info.height - 0.5) * own.per_row;
    }
    points[4] = middle_of(info);
    points[5] = points[4] + own.per_column;
    points[6] = points[4] + own.per_row;
    if (has_place_) {
      geo::Transform(own.crs, *middle_.place).to_local(points);
    }
    for (int k = 0; k < 4; ++k) {
      if (!std::isfinite(points[k].x + points[k].y)) continue;
      least = glm::min(least, points[k]);
      most = glm::max(most, points[k]);
    }
    const dvec2 a = points[5] - points[4], b = points[6] - points[4];
    const double sample_m2 = std::abs(a.x * b.y - a.y * b.x);
    add_waters(*pyramid, sample_m2);
    if (pyramid != pyramids_[0]) continue;
    cell_m_ = std::sqrt(sample_m2);
  }
  size_m_ = most - least;
  if (cell_m_ > 0.0 && std::isfinite(size_m_.x + size_m_.y)) return;
  throw Error(
      ErrorKind::bad_data,
      fmt::format("{}: the place of the samples makes no sense: the size of the area is {} x "
                  "{} m and that of a sample {} m",
                  first.path.string(), size_m_.x, size_m_.y, cell_m_));
}

void Land::add_waters(const Pyramid& pyramid, double sample_m2) {
  for (const FlatWater& water : pyramid.flat_waters()) {
    const double area_m2 =
        sample_m2 * static_cast<double>(water.cells) * std::ldexp(1.0, 2 * pyramid.base_level());
    waters_.push_back({water.level_m, area_m2});
  }
}

void Land::find_sea() {
  RasterStatistics all;
  for (const auto& pyramid : pyramids_) all.add(pyramid->statistics());
  if (all.known() == 0) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: no sample has a height", files_[0].path.string()));
  }
  lowest_m_ = all.lowest;
  highest_m_ = all.highest;
  has_sea_ = show_sea(all);
}

std::shared_ptr<const LocalLand> Land::around(const LandPoint& point, double reach_m) const {
  return std::make_shared<const LocalLand>(*this, point, reach_m);
}

}  // namespace aerostat::land
