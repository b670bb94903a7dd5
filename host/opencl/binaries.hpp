#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "opencl/device.hpp"

/// Compiled programs that are kept for the next run, for drivers that keep none themselves.
namespace aerostat::opencl {

/// Whether programs for this platform are kept: AEROSTAT_KERNEL_BINARIES=on or off says so; else
/// all are but those of drivers known to keep what they compile (PoCL, NVIDIA, Mesa's rusticl).
/// Throws Error{usage} if the variable says something else.
bool keeps_binaries(const std::string& platform);

/// All that a program's machine code depends on, as a text.
std::string binary_key(const Device& device, std::string_view text, std::string_view options);

/// A private folder of compiled programs, one a file with its key and a checksum, that several
/// processes may use at once.
class BinaryStore {
 public:
  /// Makes the folder if it is not there. A store whose folder cannot be used, or that has none,
  /// finds nothing and keeps nothing: programs are compiled for each run then.
  explicit BinaryStore(std::optional<std::filesystem::path> folder,
                       std::uint64_t most_bytes = 256ull << 20);

  /// The folder "aerostat/binaries" in the user's cache folder.
  static BinaryStore of_user();

  /// The binary that was kept under `key`; a damaged file is removed and counts as none.
  std::optional<std::string> find(const std::string& key) const;

  /// Keeps `binary`, then removes files that were not used for the longest time while all take more
  /// than `most_bytes`.
  void keep(const std::string& key, std::string_view binary) const;

  void drop(const std::string& key) const;

 private:
  std::filesystem::path file_of(const std::string& key) const;
  void remove_oldest() const;

  std::optional<std::filesystem::path> folder_;
  std::uint64_t most_bytes_;
};

}  // namespace aerostat::opencl
