#pragma once

#include <cstdint>
#include <span>

/// The readers of GeoTIFF files and of coordinate reference systems, as fuzzing calls them. They
/// throw Error{bad_data} for what they refuse.
namespace aerostat::test {

void read_geotiff(std::span<const std::uint8_t> bytes);

/// Reads a text of a coordinate reference system and transforms points by it.
void read_crs(std::span<const std::uint8_t> bytes);

/// Reads geokeys. The first two bytes are the numbers of shorts and of doubles, and the rest is
/// text.
void read_geokeys(std::span<const std::uint8_t> bytes);

}  // namespace aerostat::test
