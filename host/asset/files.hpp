#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "asset/read.hpp"

namespace aerostat::asset {

/// Returns the bytes of a regular file. Throws Error{io} if it cannot be read, and Error{bad_data}
/// if it has more than `most` bytes.
std::string bytes_of(const std::filesystem::path& file, std::uint64_t most);

/// The files that a model refers to.
class Files {
 public:
  /// `file` is the file of the model. References are relative to its folder.
  Files(std::filesystem::path file, const ReadOptions& options);

  /// Returns the path that a reference leads to. Slashes and backslashes separate folders. If no
  /// file has the name, one whose name differs only by capital letters is taken. Throws
  /// Error{bad_data} if there is no such file or if it must not be read.
  std::filesystem::path find(std::string_view reference) const;

  /// Returns the bytes of the file at a path that `find` has returned. Throws what bytes_of throws.
  std::string read(const std::filesystem::path& path) const;

 private:
  std::filesystem::path beside_;  // the folder of the model
  std::filesystem::path root_;    // nothing outside of it is read
  bool allow_external_;
  std::uint64_t most_bytes_;
};

/// Returns whether a reference begins with a scheme such as "http:".
bool has_scheme(std::string_view reference);

/// Returns a reference whose percent-encoded bytes are decoded. What is no code stays as it is.
std::string percent_decoded(std::string_view reference);

}  // namespace aerostat::asset
