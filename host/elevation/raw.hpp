#pragma once

#include <filesystem>
#include <memory>

#include "elevation/bytes.hpp"
#include "elevation/format.hpp"
#include "elevation/side_files.hpp"

/// Files of samples alone: .r16 (uint16), .r32 (float32) and .raw, little-endian unless the user
/// says otherwise.
namespace aerostat::elevation {

extern const Format kRawFormat;

std::unique_ptr<Raster> read_raw(std::shared_ptr<const ByteSource> bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options);

}  // namespace aerostat::elevation
