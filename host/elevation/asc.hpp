#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "elevation/bytes.hpp"
#include "elevation/format.hpp"
#include "elevation/side_files.hpp"

/// ESRI's grid as text: a header of keys and values, and the heights row by row from the north.
namespace aerostat::elevation {

extern const Format kAscFormat;

/// The heights of files with at most this many samples are kept in memory.
inline constexpr std::uint64_t kMostAscInMemory = std::uint64_t{1} << 26;

std::unique_ptr<Raster> read_asc(std::shared_ptr<const ByteSource> bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options,
                                 std::uint64_t most_in_memory = kMostAscInMemory);

}  // namespace aerostat::elevation
