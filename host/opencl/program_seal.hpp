#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace aerostat::opencl {

/// The state of a file when it was sealed. As long as its numbers do not change, its bytes have not
/// changed.
struct SealedFile {
  std::uint64_t bytes = 0;
  std::uint64_t inode = 0;
  std::int64_t modified_ns = 0, changed_ns = 0;
  std::uint64_t checksum = 0;

  bool operator==(const SealedFile&) const = default;
};

/// The sealed files of a program by their paths relative to the program's folder.
using Seal = std::map<std::string, SealedFile>;

inline constexpr const char* kSealName = "aerostat.seal";

enum class SealState { none, whole, damaged };

/// Reads the seal in `folder`. A seal of another version counts as missing.
SealState read_seal(const std::filesystem::path& folder, Seal& seal);

/// Writes the seal into `folder` and returns whether it was written.
bool write_seal(const std::filesystem::path& folder, const Seal& seal);

}  // namespace aerostat::opencl
