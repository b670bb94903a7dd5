#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "elevation/format.hpp"
#include "elevation/side_files.hpp"

/// OpenEXR images whose channel Y, R, Z or only channel is the height.
namespace aerostat::elevation {

extern const Format kExrFormat;

std::unique_ptr<Raster> read_exr(std::span<const std::uint8_t> bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options);

}  // namespace aerostat::elevation
