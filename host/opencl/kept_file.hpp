#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// Reads and writes small files that outlive a run, in folders that several processes use at once.
namespace aerostat::opencl {

/// Returns the bytes of a regular file, or nothing if there is no readable regular file.
std::optional<std::string> read_kept_file(const std::filesystem::path& path);

/// Writes the file completely or not at all. Writes a temporary file beside it to the disk and then
/// renames it, so that other processes see either the old file or the new one. Returns whether the
/// file was written.
bool write_kept_file(const std::filesystem::path& path, std::string_view bytes);

/// Renames a file or a folder with all its contents and then removes it, so that it leaves its path
/// at once. Returns whether nothing is left at the path.
bool remove_kept(const std::filesystem::path& path);

}  // namespace aerostat::opencl
