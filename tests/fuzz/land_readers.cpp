#include "land_readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "elevation/picture.hpp"
#include "fuzz_file.hpp"
#include "geo/place.hpp"
#include "labels/places.hpp"

namespace aerostat::test {
namespace {

constexpr int kMostSide = 64;  // of the windows that are read

bool is_share(float value) {
  return value >= 0.0f && value <= 1.0f;
}

/// Reads the first and the last pixels of each level.
void read_some(const elevation::Picture& picture) {
  std::vector<elevation::vec4> pixels(std::size_t{kMostSide} * kMostSide);
  for (std::size_t level = 0; level < picture.levels().size(); ++level) {
    const auto [width, height] = picture.levels()[level];
    const int columns = std::min(width, kMostSide), rows = std::min(height, kMostSide);
    for (const elevation::Window& window :
         {elevation::Window{0, 0, columns, rows},
          elevation::Window{width - columns, height - rows, columns, rows}}) {
      picture.read(static_cast<int>(level), window, pixels.data());
      for (int k = 0; k < columns * rows; ++k) {
        const elevation::vec4& pixel = pixels[static_cast<std::size_t>(k)];
        if (!is_share(pixel.x) || !is_share(pixel.y) || !is_share(pixel.z) || !is_share(pixel.w)) {
          complain("a pixel has no colour");
        }
      }
    }
  }
}

}  // namespace

void read_picture(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(bytes);
  elevation::PictureOptions options;
  options.corners = {geo::Place{47.0, 9.0}, geo::Place{46.0, 10.0}};
  try {
    read_some(*elevation::open_picture(file.path(), options));
  } catch (const Error& error) {
    const std::string message = error.what();
    if (error.kind() != ErrorKind::bad_data) throw;
    if (!message.starts_with(file.path() + ": ")) complain("a message without a name: " + message);
  }
}

void read_places(std::span<const std::uint8_t> bytes) {
  const std::string text(bytes.begin(), bytes.end());
  naming_the_file([&text] {
    const bool is_geojson = text.starts_with('{');
    for (const labels::NamedPlace& named : is_geojson
                                               ? labels::places_of_geojson(text, kPath.string())
                                               : labels::places_of_csv(text, kPath.string())) {
      if (named.name.empty()) complain("a place has no name");
      if (!(std::abs(named.place.latitude_deg) <= 90.0)) complain("a latitude is beyond the pole");
      if (!std::isfinite(named.place.longitude_deg)) complain("a longitude is not finite");
      if (named.height_m && !std::isfinite(*named.height_m)) complain("a height is not finite");
    }
  });
}

}  // namespace aerostat::test
