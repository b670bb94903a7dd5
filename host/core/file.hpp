#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <span>

namespace aerostat {

/// Writes the whole file or nothing. The bytes go to a temporary file in the same folder, which
/// is synced and then renamed. Throws Error{io} with the path and the system's reason. In that
/// case nothing is left behind, and an older file stays as it was. Throws Error{usage} if `path`
/// is empty or names a folder.
/// - Symbolic links are followed. The file that they point to need not exist.
/// - Special files (pipes, devices) are written directly.
/// - Open files ("/dev/stdout", "/dev/fd/3") are written directly.
/// - The new file has the mode of the older one, and its owner and group if the user may set them.
/// - Access control lists and extended attributes of the older file are lost.
/// - A file that nobody may write (mode 0444) is left alone, even by root.
/// - Of an older file with several names (hard links), only this name gets the new content.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Writes parts one behind the other into one file, as write_file does.
void write_file_of(const std::filesystem::path& path,
                   std::span<const std::span<const std::uint8_t>> parts);

/// Throws the Error that write_file would throw, before work is done for nothing. `path` cannot
/// be written if its folder is missing or read-only, or if it is a folder or read-only itself.
void require_writable(const std::filesystem::path& path);

/// Returns whether both names stand for one regular file. Returns false if one of them does not
/// exist.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Returns whether `path` is a special file, such as a pipe or a device, or names an open file
/// such as "/dev/stdout".
bool is_special_file(const std::filesystem::path& path);

/// The identity, size and time of change of a file. A stamp that differs tells that the file was
/// replaced or written to. All numbers are zero for a file that does not exist.
struct FileStamp {
  std::uint64_t device = 0, node = 0, bytes = 0;
  std::int64_t changed_ns = 0;

  bool exists() const { return node != 0; }
  auto operator<=>(const FileStamp&) const = default;
};
/// Returns the stamp of the file that `path` leads to. Symbolic links are followed.
FileStamp file_stamp(const std::filesystem::path& path);

}  // namespace aerostat
