#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "elevation/format.hpp"

/// The ASCII elevation models of the United States Geological Survey ("Standards for Digital
/// Elevation Models", part 2): a record A that describes the file, and a record B for each column
/// from the west, with heights from the south.
namespace aerostat::elevation {

extern const Format kUsgsDemFormat;

std::unique_ptr<Raster> read_usgs_dem(std::span<const std::uint8_t> bytes,
                                      const std::filesystem::path& path,
                                      const OpenOptions& options);

}  // namespace aerostat::elevation
