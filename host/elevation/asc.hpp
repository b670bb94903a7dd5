#pragma once

#include <filesystem>
#include <memory>

#include "elevation/bytes.hpp"
#include "elevation/format.hpp"
#include "elevation/side_files.hpp"

/// ESRI's grid as text: a header of keys and values, and the heights row by row from the north.
namespace aerostat::elevation {

extern const Format kAscFormat;

std::unique_ptr<Raster> read_asc(const ByteSource& bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options);

}  // namespace aerostat::elevation
