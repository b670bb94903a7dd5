#include "elevation/geokeys.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/tiff_tags.hpp"
#include "geo/transform.hpp"

namespace aerostat::elevation {
namespace {

bool is_known(const std::string& crs) {
  try {
    geo::crs_info(crs);
    return true;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_data) throw;
    return false;
  }
}

/// Returns the WKT that programs of ESRI put into a citation, or an empty text.
std::string wkt_of_citations(const GeoKeys& keys) {
  for (const std::uint16_t key : {kProjectedCitation, kCitation, kGeogCitation}) {
    const std::string text = keys.text(key);
    constexpr std::string_view kMark = "ESRI PE String";
    const std::size_t mark = text.find(kMark);
    if (mark == std::string::npos) continue;
    const std::size_t first = text.find_first_not_of(" =", mark + kMark.size());
    if (first == std::string::npos) continue;
    const std::string wkt = text.substr(first);
    if (is_known(wkt)) return wkt;
  }
  return "";
}

/// Returns a code as a text that is known to PROJ, or an empty text.
std::string known_code(int code) {
  if (code <= 0 || code == kUserDefined) return "";
  for (const char* authority : {"EPSG", "ESRI"}) {
    const std::string crs = fmt::format("{}:{}", authority, code);
    if (is_known(crs)) return crs;
  }
  return "";
}

std::string horizontal_crs(const GeoKeys& keys, std::vector<std::string>& notes) {
  const int projected = keys.code(kProjectedType), geographic = keys.code(kGeographicType);
  const int model = keys.code(kModelType);
  const bool is_geographic =
      model == 2 || (model == 0 && projected == 0 && keys.code(kMethod) == 0 && geographic != 0);
  const int code = is_geographic ? geographic : projected;
  std::string crs = known_code(code);
  if (!crs.empty()) return crs;
  crs = wkt_of_citations(keys);
  if (!crs.empty()) return crs;
  crs = wkt_of(keys);
  if (!crs.empty() && is_known(crs)) return crs;
  if (code > 0 && code != kUserDefined) {
    notes.push_back(fmt::format(
        "The file names the coordinate reference system EPSG:{}, which PROJ does not know.", code));
  } else if (keys.code(kModelType) != 0 || projected != 0 || geographic != 0) {
    notes.emplace_back(
        "The file describes a coordinate reference system of its own by parameters that make no "
        "known one.");
  }
  return "";
}

/// Sets the factor for coordinates in a unit that is not that of the system, as in "UTM in feet".
void set_coordinate_factor(const GeoKeys& keys, GeoKeyCrs& result) {
  // Systems by parameters have the unit of the keys already.
  if (result.crs.empty() || result.crs.find('[') != std::string::npos) return;
  const geo::CrsInfo info = geo::crs_info(result.crs);
  const int angular = keys.code(kAngularUnits);
  if (info.geographic) {
    // No system of EPSG counts in these.
    if (angular == 9101) result.coordinate_factor = 180.0 / std::numbers::pi;
    if (angular == 9103) result.coordinate_factor = 1.0 / 60.0;
    if (angular == 9104) result.coordinate_factor = 1.0 / 3600.0;
  } else if (keys.code(kLinearUnits) != 0) {
    const double unit = keys.code(kLinearUnits) == kUserDefined
                            ? keys.number({kLinearUnitSize}).value_or(0.0)
                            : metres_of_unit_code(keys.code(kLinearUnits));
    const double factor = unit / info.metres_per_unit;
    // The international foot and the US survey foot differ by two millionths. Over the distances
    // that coordinates count, that makes metres.
    if (unit > 0.0 && std::abs(factor - 1.0) > 1e-7) result.coordinate_factor = factor;
  }
  if (result.coordinate_factor == 1.0) return;
  result.notes.push_back(
      fmt::format("The file's coordinates are in another unit than those of {}, and were "
                  "multiplied by {:.10g}.",
                  info.name, result.coordinate_factor));
}

/// Sets the datum and the unit of heights.
void set_vertical(const GeoKeys& keys, GeoKeyCrs& result) {
  const int code = keys.code(kVerticalType);
  if (code > 0 && code != kUserDefined) {
    // Older files name datums, 5101 to 5106, instead of systems of heights.
    for (const int candidate : {code, code >= 5101 && code <= 5106 ? code + 600 : 0}) {
      const std::string crs = fmt::format("EPSG:4326+{}", candidate);
      if (candidate == 0 || !is_known(crs)) continue;
      const geo::CrsInfo info = geo::crs_info(crs);
      result.vertical_datum = info.vertical_name;
      result.metres_per_unit = info.vertical_metres_per_unit;
    }
  }
  if (result.vertical_datum.empty()) result.vertical_datum = keys.text(kVerticalCitation);
  if (result.vertical_datum == "unknown") result.vertical_datum.clear();
  if (const double metres = metres_of_unit_code(keys.code(kVerticalUnits)); metres > 0.0) {
    result.metres_per_unit = metres;
  }
}

}  // namespace

GeoKeys::GeoKeys(const std::vector<std::uint16_t>& directory, const std::vector<double>& doubles,
                 const std::string& texts) {
  if (directory.size() < 4) return;
  const std::size_t count = std::min<std::size_t>(directory[3], directory.size() / 4 - 1);
  for (std::size_t i = 1; i <= count; ++i) {
    const std::uint16_t key = directory[4 * i], place = directory[4 * i + 1];
    const std::size_t length = directory[4 * i + 2], value = directory[4 * i + 3];
    if (place == 0) {
      numbers_[key] = {static_cast<double>(value)};
    } else if (place == kTagGeoDoubles && value + length <= doubles.size()) {
      const auto first = doubles.begin() + static_cast<std::ptrdiff_t>(value);
      numbers_[key] = {first, first + static_cast<std::ptrdiff_t>(length)};
    } else if (place == kTagGeoTexts && value < texts.size()) {
      std::string text = texts.substr(value, length);
      text.resize(text.find_last_not_of(std::string_view("| \0", 3)) + 1);
      texts_[key] = text;
    } else if (place == kTagGeoKeys && value + length <= directory.size() && length > 0) {
      numbers_[key] = {static_cast<double>(directory[value])};
    }
  }
}

int GeoKeys::code(std::uint16_t key) const {
  const auto at = numbers_.find(key);
  if (at == numbers_.end() || at->second.empty()) return 0;
  const double value = at->second.front();
  return value >= 0.0 && value <= 65535.0 ? static_cast<int>(value) : 0;
}

std::optional<double> GeoKeys::number(std::initializer_list<std::uint16_t> keys) const {
  for (const std::uint16_t key : keys) {
    const auto at = numbers_.find(key);
    if (at == numbers_.end() || at->second.empty()) continue;
    if (std::isfinite(at->second.front())) return at->second.front();
  }
  return std::nullopt;
}

std::vector<double> GeoKeys::numbers(std::uint16_t key) const {
  const auto at = numbers_.find(key);
  return at == numbers_.end() ? std::vector<double>() : at->second;
}

std::string GeoKeys::text(std::uint16_t key) const {
  const auto at = texts_.find(key);
  return at == texts_.end() ? "" : at->second;
}

GeoKeyCrs crs_of(const GeoKeys& keys) {
  GeoKeyCrs result;
  result.pixel_is_point = keys.code(kRasterType) == 2;
  if (keys.empty()) return result;
  if (keys.code(kModelType) == 3) {
    result.notes.emplace_back(
        "The file gives geocentric coordinates, which do not place a raster on the ground.");
  } else {
    result.crs = horizontal_crs(keys, result.notes);
    set_coordinate_factor(keys, result);
  }
  set_vertical(keys, result);
  return result;
}

}  // namespace aerostat::elevation
