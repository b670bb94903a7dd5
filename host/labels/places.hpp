#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geo/place.hpp"

/// Names of places on the Earth for a picture of real land.
namespace aerostat::labels {

/// A place with a name, as a file gives it.
struct NamedPlace {
  std::string name;
  geo::Place place;
  std::optional<double> height_m;  // above the sea
};

/// Reads a file of places. What begins with a brace is GeoJSON, and everything else is CSV. Throws
/// Error{io} if the file cannot be read, and the errors of the two functions below.
std::vector<NamedPlace> read_places(const std::filesystem::path& file);

/// Returns the points of GeoJSON (RFC 7946) that have a property "name": features of the types
/// Point and MultiPoint. Their height is the property "ele" or "elevation", or else the third
/// coordinate. Other features are passed over. `name` is that of the file for messages. Throws
/// Error{bad_data} with line and column for anything that is wrong, or if no place is left.
std::vector<NamedPlace> places_of_geojson(std::string_view text, const std::string& name);

/// Returns the places of a table with a header. Columns are "name", "lat" or "latitude", "lon",
/// "lng" or "longitude", and if there are heights, "ele", "elevation" or "height". Cells are
/// separated by commas, semicolons or tabs, whichever the header has most of. Between semicolons
/// and tabs, decimal commas are read as well. Quoted cells are those of RFC 4180. Rows without a
/// name are passed over. Throws Error{bad_data} with the line of anything that is wrong, or if no
/// place is left.
std::vector<NamedPlace> places_of_csv(std::string_view text, const std::string& name);

}  // namespace aerostat::labels
