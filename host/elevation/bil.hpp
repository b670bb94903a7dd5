#pragma once

#include <filesystem>
#include <memory>

#include "elevation/bytes.hpp"
#include "elevation/format.hpp"
#include "elevation/side_files.hpp"

/// Samples beside a text file .hdr that describes them: .bil, .flt, and .dem of GTOPO30.
namespace aerostat::elevation {

extern const Format kBilFormat;

std::unique_ptr<Raster> read_bil(std::shared_ptr<const ByteSource> bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options);

}  // namespace aerostat::elevation
