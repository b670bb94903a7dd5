#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// Small files that outlive a run, in folders that several processes use at once.
namespace aerostat::opencl {

/// The bytes of a regular file, or nothing if it cannot be read as one.
std::optional<std::string> read_kept_file(const std::filesystem::path& path);

/// Writes the file whole or not at all: a temporary file beside it, on the disk before it is
/// renamed. Other processes see the old file or the new one. Returns whether it was written.
bool write_kept_file(const std::filesystem::path& path, std::string_view bytes);

/// Takes a file or a folder with all that is in it away from its path at once, then removes it.
/// Returns whether nothing is left at the path.
bool remove_kept(const std::filesystem::path& path);

}  // namespace aerostat::opencl
