#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Compressed files that hold one file of heights.
namespace aerostat::elevation {

struct ZipMember {
  std::string name;  // without folders
  std::vector<std::uint8_t> bytes;
};

/// Returns the member of a zip file whose name ends with `ending`, in any case. Throws
/// Error{bad_data} with the file's name if there is no such member or more than one, if it is
/// longer than `most`, encrypted, damaged or packed by a method other than "stored" and "deflated".
ZipMember unpack_zip(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                     std::string_view ending, std::uint64_t most);

/// Returns the content of a gzip file. Throws Error{bad_data} if it is damaged or longer than
/// `most`.
std::vector<std::uint8_t> unpack_gzip(std::span<const std::uint8_t> bytes,
                                      const std::filesystem::path& path, std::uint64_t most);

}  // namespace aerostat::elevation
