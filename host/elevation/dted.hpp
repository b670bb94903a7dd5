#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "elevation/format.hpp"

/// Digital Terrain Elevation Data (MIL-PRF-89020B), levels 0 to 2: columns of big-endian numbers
/// with a sign bit, from the west and from the south.
namespace aerostat::elevation {

extern const Format kDtedFormat;

std::unique_ptr<Raster> read_dted(std::span<const std::uint8_t> bytes,
                                  const std::filesystem::path& path, const OpenOptions& options);

}  // namespace aerostat::elevation
