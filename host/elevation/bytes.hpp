#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace aerostat::elevation {

/// The bytes of a file, in memory or not. It may be used from any thread.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  virtual std::uint64_t size() const = 0;

  /// Fills `bytes` with `count` pieces of equal length. They begin at `offset`, each `stride` bytes
  /// behind the one before. All of them must lie in the file. Throws Error{io} if the file cannot
  /// be read or has become shorter.
  virtual void read(std::uint64_t offset, std::uint64_t stride, std::size_t count,
                    std::span<std::uint8_t> bytes) const = 0;
};

/// Returns the bytes of a regular file, which is opened at each reading so that any number of files
/// may be in use. Throws Error{io} if it is not a regular
/// file.
std::shared_ptr<const ByteSource> file_bytes(const std::filesystem::path& path);

/// Returns bytes that are in memory.
std::shared_ptr<const ByteSource> memory_bytes(std::vector<std::uint8_t> bytes);

/// Reads a whole file. Throws Error{bad_data} if it is longer than `most`.
std::vector<std::uint8_t> read_whole(const std::filesystem::path& path, std::uint64_t most);

}  // namespace aerostat::elevation
