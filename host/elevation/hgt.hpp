#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "elevation/bytes.hpp"
#include "elevation/format.hpp"

/// Tiles of one degree of the Shuttle Radar Topography Mission: big-endian int16 from the north
/// without a header, as they are, zipped or gzipped.
namespace aerostat::elevation {

extern const Format kHgtFormat;

/// Returns the latitude and longitude of the south-west corner that a name such as "N46E009.hgt"
/// or "s14w067_raw.hgt" gives.
std::optional<std::array<double, 2>> corner_of_name(const std::string& name);

/// `name` gives the place of the tile.
std::unique_ptr<Raster> read_hgt(std::shared_ptr<const ByteSource> bytes, const std::string& name,
                                 const std::filesystem::path& path, const OpenOptions& options);

/// Reads a tile in a zip or gzip file.
std::unique_ptr<Raster> read_packed_hgt(std::span<const std::uint8_t> bytes,
                                        const std::filesystem::path& path,
                                        const OpenOptions& options);

}  // namespace aerostat::elevation
