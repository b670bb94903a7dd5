#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <span>

namespace aerostat {

/// Writes the file whole or not at all: a temporary file beside it, checked, synced, renamed.
/// Throws Error{io} with the path and the system's reason; then nothing is left behind and an older
/// file stays as it was.
/// - Through symbolic links what they point to is written, also where that does not exist yet.
/// - Pipes, devices and other special files, and open ones such as "/dev/stdout" and "/dev/fd/3",
/// are
///   written to directly.
/// - An older file's mode stays, its owner and group as far as the user may give them; its ACLs and
///   extended attributes do not. One that nobody may write (mode 0444) is left alone, by root too.
/// - Of an older file with several names (hard links) this name alone gets the new content.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Throws as write_file does early, before work is done for nothing, if `path` cannot be written:
/// its folder is missing or read-only, it is a folder or read-only.
void require_writable(const std::filesystem::path& path);

/// Whether both are one regular file, by whatever names. False if one of them does not exist.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Whether it is a pipe, a device or the like, or named as an open file ("/dev/stdout").
bool is_special_file(const std::filesystem::path& path);

/// What tells that a file was replaced or written to: all zeros for one that is not there. Links
/// are followed.
struct FileStamp {
  std::uint64_t device = 0, node = 0, bytes = 0;
  std::int64_t changed_ns = 0;

  bool exists() const { return node != 0; }
  auto operator<=>(const FileStamp&) const = default;
};
FileStamp file_stamp(const std::filesystem::path& path);

}  // namespace aerostat
