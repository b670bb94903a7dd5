#include "labels/places.hpp"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"
#include "labels/place_limits.hpp"

namespace aerostat::labels {
namespace {

/// Returns the file's content, or a byte more than is allowed of a longer one.
std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(kMostFileBytes + 1, '\0');
  if (!file || std::filesystem::is_directory(path)) {
    throw Error(ErrorKind::io, fmt::format("{}: cannot read the places", path.string()));
  }
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

}  // namespace

std::string fault_of(const NamedPlace& place) {
  const auto [latitude, longitude] = place.place;
  if (!(std::fabs(latitude) <= 90.0)) {
    return fmt::format("latitude {} (expected -90 to 90)", latitude);
  }
  if (!(std::fabs(longitude) <= 180.0)) {
    return fmt::format("longitude {} (expected -180 to 180)", longitude);
  }
  if (place.height_m && !(std::fabs(*place.height_m) <= kHighest_m)) {
    return fmt::format("height {} m (expected -100000 to 100000)", *place.height_m);
  }
  return {};
}

void require_places(const std::vector<NamedPlace>& places, const std::string& name) {
  if (!places.empty()) return;
  throw Error(ErrorKind::bad_data, fmt::format("{}: found no place with a name", name));
}

std::vector<NamedPlace> read_places(const std::filesystem::path& file) {
  const std::string text = text_of(file), name = file.string();
  if (text.size() > kMostFileBytes) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: found more than 16 MiB of places, expected fewer", name));
  }
  const std::size_t mark = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const std::size_t first = text.find_first_not_of(" \t\r\n", mark);
  const std::string_view content = std::string_view(text).substr(mark);
  if (first != std::string::npos && text[first] == '{') return places_of_geojson(content, name);
  return places_of_csv(content, name);
}

}  // namespace aerostat::labels
