#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "opencl/device.hpp"

/// Keeps compiled programs for the next run. It serves drivers that keep none themselves.
namespace aerostat::opencl {

/// Returns whether programs for this platform are kept. AEROSTAT_KERNEL_BINARIES=on or off decides.
/// If the variable is unset or empty, programs are kept for every platform except those whose
/// drivers are known to keep what they compile (PoCL, NVIDIA, Mesa's rusticl). Throws Error{usage}
/// if the variable has another value.
bool keeps_binaries(const std::string& platform);

/// Returns a text of everything that a program's machine code depends on.
std::string binary_key(const Device& device, std::string_view text, std::string_view options);

/// A private folder of compiled programs. Each program is one file with its key and a checksum.
/// Several processes may use the folder at once.
class BinaryStore {
 public:
  /// Makes the folder if it does not exist. A store without a usable folder finds nothing and keeps
  /// nothing, so programs are compiled in each run.
  explicit BinaryStore(std::optional<std::filesystem::path> folder,
                       std::uint64_t most_bytes = 256ull << 20);

  /// Returns the store in the folder "aerostat/binaries" of the user's cache folder.
  static BinaryStore of_user();

  /// Returns the binary that was kept under `key`, or nothing. A damaged file is removed and counts
  /// as missing.
  std::optional<std::string> find(const std::string& key) const;

  /// Keeps `binary` under `key`. Then removes the files that were not used for the longest time
  /// until the rest take at most `most_bytes`.
  void keep(const std::string& key, std::string_view binary) const;

  void drop(const std::string& key) const;

 private:
  std::filesystem::path file_of(const std::string& key) const;
  void remove_oldest() const;

  std::optional<std::filesystem::path> folder_;
  std::uint64_t most_bytes_;
};

}  // namespace aerostat::opencl
