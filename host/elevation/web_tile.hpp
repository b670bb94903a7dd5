#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elevation/raster.hpp"

/// Tiles of web maps whose colours are heights.
namespace aerostat::elevation {

/// How three bytes become metres: base_m + step_m * (65536 red + 256 green + blue).
struct TileEncoding {
  const char* name = "";
  double base_m = 0.0, step_m = 1.0;
};

/// The heights are -32768 + 256 red + green + blue / 256.
inline constexpr TileEncoding kTerrarium{"terrarium", -32768.0, 1.0 / 256.0};
/// The heights are -10000 + 0.1 (65536 red + 256 green + blue).
inline constexpr TileEncoding kTerrainRgb{"terrain-rgb", -10000.0, 0.1};

/// Returns the encoding of a name, or nothing.
std::optional<TileEncoding> encoding_of(const std::string& name);

/// Returns the heights of pixels with `channels` bytes each (3, or 4 with opacity). Pixels that are
/// fully transparent or black are voids.
std::vector<float> tile_heights(std::span<const std::uint8_t> pixels, int channels,
                                const TileEncoding& encoding);

/// Returns the encoding by which pixels make heights that the Earth has and that change little from
/// a pixel to the next, or nothing.
std::optional<TileEncoding> guess_encoding(std::span<const std::uint8_t> pixels, int channels,
                                           int width);

/// The number of a tile: of its level, of its column from the west and of its row from the north.
struct TileNumber {
  int z = 0, x = 0, y = 0;
};

/// Returns the number in a name such as "terrarium_11_385_803.png" or "11/385/803.png".
std::optional<TileNumber> tile_number_of(const std::filesystem::path& path);

/// Returns where the samples of a tile of `side` pixels a side lie, in Web Mercator.
Georeference place_of_tile(const TileNumber& tile, int side);

}  // namespace aerostat::elevation
