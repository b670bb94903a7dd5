// The place of a GeoTIFF file.
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "elevation/geokeys.hpp"
#include "elevation/geotiff_info.hpp"
#include "elevation/reading.hpp"
#include "elevation/side_files.hpp"
#include "elevation/tiff_tags.hpp"
#include "geo/transform.hpp"

namespace aerostat::elevation {
namespace {

/// Moves the origin of a place from the corner of the first sample to its centre.
void move_to_centre(Georeference& place) {
  place.origin += 0.5 * (place.per_column + place.per_row);
}

/// Returns the place that the tags give, with the centre of the first sample as its origin.
std::optional<Georeference> place_of_tags(const TiffHandle& handle, bool pixel_is_point,
                                          RasterInfo& info) {
  const std::vector<double> scale = doubles_of(handle, kTagPixelScale);
  const std::vector<double> ties = doubles_of(handle, kTagTiepoints);
  const std::vector<double> matrix = doubles_of(handle, kTagTransformation);
  Georeference place;
  if (matrix.size() >= 8) {
    place.per_column = dvec2(matrix[0], matrix[4]);
    place.per_row = dvec2(matrix[1], matrix[5]);
    place.origin = dvec2(matrix[3], matrix[7]);
  } else if (scale.size() >= 2 && ties.size() >= 6) {
    if (scale[1] < 0.0) {
      info.notes.emplace_back(
          "The file gives a negative distance of its rows; they are taken to run from north to "
          "south, as other programs take them.");
    }
    place.per_column = dvec2(scale[0], 0.0);
    place.per_row = dvec2(0.0, -std::abs(scale[1]));
    place.origin = dvec2(ties[3], ties[4]) - ties[0] * place.per_column - ties[1] * place.per_row;
  } else if (ties.size() > 6) {
    refuse(info.path,
           "the file is placed only by ground control points, as scans and radar images are; "
           "\"gdalwarp\" makes a file that is placed by a transformation");
  } else {
    return std::nullopt;
  }
  if (!pixel_is_point) move_to_centre(place);
  return place;
}

void require_cells(const Georeference& place, const RasterInfo& info) {
  const dvec2 a = place.per_column, b = place.per_row;
  const dvec2 far =
      place.origin + static_cast<double>(info.width) * a + static_cast<double>(info.height) * b;
  const double area = std::abs(a.x * b.y - a.y * b.x);
  const double sides = std::hypot(a.x, a.y) * std::hypot(b.x, b.y);
  if (std::isfinite(place.origin.x) && std::isfinite(place.origin.y) && std::isfinite(far.x) &&
      std::isfinite(far.y) && area > 1e-6 * sides && area > 0.0) {
    return;
  }
  refuse(info.path,
         fmt::format("its place makes no sense: the first sample is at ({}, {}), the next "
                     "in its row {}, {} from it and the next in its column {}, {}",
                     place.origin.x, place.origin.y, a.x, a.y, b.x, b.y));
}

void set_crs(const GeoKeyCrs& keys, const SideFiles& beside, const OpenOptions& options,
             RasterInfo& info) {
  Georeference& place = *info.georeference;
  if (!options.crs.empty()) {
    geo::crs_info(options.crs);
    place.crs = options.crs;
    return;
  }
  place.crs = keys.crs;
  place.origin *= keys.coordinate_factor;
  place.per_column *= keys.coordinate_factor;
  place.per_row *= keys.coordinate_factor;
  info.notes.insert(info.notes.end(), keys.notes.begin(), keys.notes.end());
  if (!place.crs.empty()) return;
  place.crs = crs_of_prj(beside.prj, info.notes);
  const char* source = ".prj";
  if (place.crs.empty()) {
    place.crs = beside.aux_wkt;
    source = ".aux.xml";
  }
  if (place.crs.empty()) {
    info.notes.emplace_back(
        "The file does not say its coordinate reference system, and no .prj file beside it does. "
        "/terrain/crs names it.");
    return;
  }
  info.notes.push_back(
      fmt::format("The coordinate reference system, {}, is from the {} file beside it.",
                  geo::crs_info(place.crs).name, source));
}

}  // namespace

void set_place(const TiffHandle& handle, const OpenOptions& options, RasterInfo& info,
               double& vertical_unit) {
  const GeoKeys keys(shorts_of(handle, kTagGeoKeys), doubles_of(handle, kTagGeoDoubles),
                     text_of(handle, kTagGeoTexts));
  const GeoKeyCrs crs = crs_of(keys);
  info.vertical_datum = crs.vertical_datum;
  vertical_unit = crs.metres_per_unit;
  info.georeference = place_of_tags(handle, crs.pixel_is_point, info);
  SideFiles beside;
  if (!info.georeference || crs.crs.empty()) beside = side_files_of(info.path);
  if (!info.georeference && beside.world) {
    const auto& [a, d, b, e, c, f] = *beside.world;
    info.georeference = Georeference{"", dvec2(c, f), dvec2(a, d), dvec2(b, e)};
    info.notes.emplace_back("The place of the file is from the world file beside it.");
  }
  if (!info.georeference && options.cell_m) {
    info.georeference = place_without_earth(info, options);
    info.notes.emplace_back(
        "The file does not say where it lies, and the distance of its samples is taken from "
        "/terrain/cell_m.");
    return;
  }
  if (!info.georeference) return;
  require_cells(*info.georeference, info);
  set_crs(crs, beside, options, info);
}

}  // namespace aerostat::elevation
