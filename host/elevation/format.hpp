#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "elevation/open.hpp"
#include "elevation/raster.hpp"

namespace aerostat::elevation {

/// A kind of file. To add one, write its reader in a file of its own and list it in open.cpp.
struct Format {
  const char* name = "";
  /// Returns whether a file is of this format. `head` is its first 4096 bytes, or all of it.
  bool (*matches)(std::span<const std::uint8_t> head, const std::filesystem::path& path) = nullptr;
  std::unique_ptr<Raster> (*open)(const std::filesystem::path& path,
                                  const OpenOptions& options) = nullptr;
};

}  // namespace aerostat::elevation
