#include "elevation/plausible.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/reading.hpp"
#include "geo/transform.hpp"

namespace aerostat::elevation {
namespace {

/// The range of the coordinates of a raster, and the size of its cells.
struct Extent {
  dvec2 lowest{0.0}, highest{0.0};
  double cell = 0.0;  // the longer side
};

Extent extent_of(const RasterInfo& info) {
  const Georeference& place = *info.georeference;
  Extent extent;
  extent.lowest = extent.highest = place.origin;
  for (const int i : {0, info.width - 1}) {
    for (const int j : {0, info.height - 1}) {
      const dvec2 corner = place.origin + static_cast<double>(i) * place.per_column +
                           static_cast<double>(j) * place.per_row;
      extent.lowest = glm::min(extent.lowest, corner);
      extent.highest = glm::max(extent.highest, corner);
    }
  }
  extent.cell = std::max(std::hypot(place.per_column.x, place.per_column.y),
                         std::hypot(place.per_row.x, place.per_row.y));
  return extent;
}

/// Returns the properties of a coordinate reference system, or nothing if PROJ does not know it.
/// The error of an unknown system is thrown later, where its coordinates are needed.
std::optional<geo::CrsInfo> known_crs(const std::string& crs) {
  try {
    return geo::crs_info(crs);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_data) throw;
    return std::nullopt;
  }
}

}  // namespace

void require_plausible_place(const RasterInfo& info, bool crs_is_from_user, const char* option) {
  if (!info.georeference || info.georeference->crs.empty()) return;
  const std::optional<geo::CrsInfo> known = known_crs(info.georeference->crs);
  if (!known) return;
  const geo::CrsInfo& crs = *known;
  const Extent extent = extent_of(info);
  const double furthest_y = std::max(std::abs(extent.lowest.y), std::abs(extent.highest.y));
  const double furthest_x = std::max(std::abs(extent.lowest.x), std::abs(extent.highest.x));
  // Rasters of the whole Earth reach half a cell beyond the poles, or count from 0 to 360 degrees.
  const double margin = std::min(extent.cell, 1.0);
  const bool is_off_globe = furthest_y > 90.0 + margin || furthest_x > 360.0 + margin;
  const bool is_coarse = extent.cell > 1.0 && !crs_is_from_user;
  if (crs.geographic && (is_off_globe || is_coarse)) {
    refuse(info.path,
           fmt::format("its coordinate reference system is said to be {}, whose coordinates are "
                       "degrees, but they run from {:.8g} to {:.8g} and from {:.8g} to {:.8g} in "
                       "cells of {:.4g}: read as degrees, {}; they look like metres. Set {} "
                       "to the system that is meant, for example \"EPSG:32632\"",
                       crs.name, extent.lowest.x, extent.highest.x, extent.lowest.y,
                       extent.highest.y, extent.cell,
                       is_off_globe ? "they lie beyond the poles or the globe"
                                    : "a cell is larger than a mountain range",
                       option));
  }
  const bool looks_like_degrees =
      furthest_x <= 400.0 && furthest_y <= 91.0 && extent.cell < 0.1 && !crs_is_from_user;
  if (!crs.geographic && looks_like_degrees) {
    refuse(
        info.path,
        fmt::format("its coordinate reference system is said to be {}, whose coordinates are "
                    "lengths, but they run from {:.8g} to {:.8g} and from {:.8g} to {:.8g} in "
                    "cells of {:.4g}: read as metres, all of it is {:.3g} m wide; they look like "
                    "degrees. Set {} to the system that is meant, for example \"EPSG:4326\"",
                    crs.name, extent.lowest.x, extent.highest.x, extent.lowest.y, extent.highest.y,
                    extent.cell, extent.highest.x - extent.lowest.x, option));
  }
}

}  // namespace aerostat::elevation
