#pragma once

#include <cstdint>
#include <span>

/// The readers of what lies on real land, as fuzzing calls them. They throw Error{bad_data} for
/// what they refuse.
namespace aerostat::test {

/// Reads a picture that lies over the land: GeoTIFF, PNG or JPEG.
void read_picture(std::span<const std::uint8_t> bytes);

/// Reads names of places, as GeoJSON or CSV.
void read_places(std::span<const std::uint8_t> bytes);

}  // namespace aerostat::test
