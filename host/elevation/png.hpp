#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "elevation/format.hpp"
#include "elevation/side_files.hpp"

/// PNG images: grey ones whose heights the user gives, and tiles of web maps.
namespace aerostat::elevation {

extern const Format kPngFormat;
/// Pictures that cannot hold heights. Their reader says so.
extern const Format kLossyPictureFormat;

std::unique_ptr<Raster> read_png(std::span<const std::uint8_t> bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options);

}  // namespace aerostat::elevation
