#include "asset/read.hpp"

#include <fstream>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "core/error.hpp"

namespace aerostat::asset {
namespace {

/// Returns the bytes of a regular file that has at most `most` of them.
std::string bytes_of(const std::filesystem::path& file, std::uint64_t most) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed)) {
    throw Error(ErrorKind::io,
                fmt::format("{}: {}", file.string(), failed ? failed.message() : "is not a file"));
  }
  const std::uint64_t size = std::filesystem::file_size(file, failed);
  if (!failed && size > most) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: the file has {} bytes, and at most {} are read", file.string(),
                            size, most));
  }
  std::string bytes(failed ? 0 : static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (failed || !stream) {
    throw Error(ErrorKind::io, fmt::format("{}: the file cannot be read", file.string()));
  }
  return bytes;
}

}  // namespace

Model read(const std::filesystem::path& file, const ReadOptions& options) {
  const std::string bytes = bytes_of(file, options.limits.file_bytes);
  const std::optional<Format> format = format_of(bytes, file);
  if (!format) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: found no model, expected a file in glTF 2.0 (.gltf or .glb), OBJ, "
                            "PLY or STL",
                            file.string()));
  }
  return read_bytes(bytes, *format, file, options);
}

Model read_bytes(std::string_view, Format, const std::filesystem::path& file, const ReadOptions&) {
  throw Error(ErrorKind::bad_data,
              fmt::format("{}: models of this format are not read yet", file.string()));
}

}  // namespace aerostat::asset
