#include "elevation/web_tile.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <system_error>

#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

/// Returns a whole number of digits alone, or -1.
int number_in(std::string_view text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value);
  return code == std::errc{} && stop == end && !text.empty() && text[0] != '-' ? value : -1;
}

std::optional<TileNumber> checked(int z, int x, int y) {
  if (z < 0 || z > 24 || x < 0 || y < 0 || x >= 1 << z || y >= 1 << z) return std::nullopt;
  return TileNumber{z, x, y};
}

}  // namespace

std::optional<TileEncoding> encoding_of(const std::string& name) {
  for (const TileEncoding& encoding : {kTerrarium, kTerrainRgb}) {
    if (name == encoding.name) return encoding;
  }
  return std::nullopt;
}

std::vector<float> tile_heights(std::span<const std::uint8_t> pixels, int channels,
                                const TileEncoding& encoding) {
  const auto step = static_cast<std::size_t>(channels);
  std::vector<float> heights(pixels.size() / step);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const std::uint8_t* pixel = pixels.data() + i * step;
    const int value = pixel[0] << 16 | pixel[1] << 8 | pixel[2];
    const bool is_void = value == 0 || (channels == 4 && pixel[3] == 0);
    heights[i] = is_void ? std::numeric_limits<float>::quiet_NaN()
                         : static_cast<float>(encoding.base_m + encoding.step_m * value);
  }
  return heights;
}

std::optional<TileEncoding> guess_encoding(std::span<const std::uint8_t> pixels, int channels,
                                           int width) {
  for (const TileEncoding& encoding : {kTerrarium, kTerrainRgb}) {
    const std::vector<float> heights = tile_heights(pixels, channels, encoding);
    std::size_t known = 0, possible = 0;
    std::vector<float> steps;
    for (std::size_t i = 0; i < heights.size(); ++i) {
      if (std::isnan(heights[i])) continue;
      ++known;
      if (heights[i] > -12000.0f && heights[i] < 9000.0f) ++possible;
      if (i % static_cast<std::size_t>(width) == 0 || std::isnan(heights[i - 1])) continue;
      steps.push_back(std::abs(heights[i] - heights[i - 1]));
    }
    // A few pixels may be wrong. Colours of a picture are wrong nearly everywhere.
    if (known == 0 || possible < known - known / 500 || steps.empty()) continue;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    if (*middle < 500.0f) return encoding;
  }
  return std::nullopt;
}

std::optional<TileNumber> tile_number_of(const std::filesystem::path& path) {
  std::string stem = path.stem().string();
  if (stem.ends_with("@2x")) stem.resize(stem.size() - 3);
  const std::filesystem::path column = path.parent_path();
  if (const int y = number_in(stem); y >= 0) {
    return checked(number_in(column.parent_path().filename().string()),
                   number_in(column.filename().string()), y);
  }
  std::array<int, 3> numbers{};
  for (int i = 2; i >= 0; --i) {
    const std::size_t mark = stem.find_last_of("_-");
    if (mark == std::string::npos && i > 0) return std::nullopt;
    const std::size_t first = mark == std::string::npos ? 0 : mark + 1;
    numbers[static_cast<std::size_t>(i)] = number_in(std::string_view(stem).substr(first));
    stem.resize(mark == std::string::npos ? 0 : mark);
  }
  return checked(numbers[0], numbers[1], numbers[2]);
}

Georeference place_of_tile(const TileNumber& tile, int side) {
  // Half the length of the equator of WGS 84.
  constexpr double kHalf_m = 20037508.342789244;
  const double tile_m = 2.0 * kHalf_m / (1 << tile.z), pixel_m = tile_m / side;
  Georeference place;
  place.crs = "EPSG:3857";
  place.origin =
      dvec2(-kHalf_m + tile.x * tile_m + 0.5 * pixel_m, kHalf_m - tile.y * tile_m - 0.5 * pixel_m);
  place.per_column = dvec2(pixel_m, 0.0);
  place.per_row = dvec2(0.0, -pixel_m);
  return place;
}

}  // namespace aerostat::elevation
