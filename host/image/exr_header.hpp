#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

/// The frame of the header of an OpenEXR file, which is looked through before OpenEXR reads it:
/// OpenEXR allocates as much memory as a file says that it needs.
namespace aerostat::image {

/// Returns the number of 4 bytes at a place in the file.
inline std::uint32_t exr_number(std::span<const std::uint8_t> bytes, std::size_t at) {
  return bytes[at] | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16 |
         std::uint32_t{bytes[at + 3]} << 24;
}

/// Returns whether a file has several parts, each with a header of its own.
inline bool has_exr_parts(std::span<const std::uint8_t> bytes) {
  constexpr std::uint32_t kSeveralParts = 0x1000;
  return bytes.size() >= 8 && (exr_number(bytes, 4) & kSeveralParts) != 0;
}

/// Returns the text that begins at `at`, and sets `at` behind the zero at its end.
inline std::string_view exr_text(std::span<const std::uint8_t> bytes, std::size_t& at) {
  const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(at, bytes.size()));
  const auto zero = std::find(first, bytes.end(), std::uint8_t{0});
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()) + (first - bytes.begin()),
                              static_cast<std::size_t>(zero - first));
  at = static_cast<std::size_t>(zero - bytes.begin()) + 1;
  return text;
}

/// An attribute that is longer than the rest of its file.
struct LongExrAttribute {
  std::string_view name;  // empty: there is none
  std::size_t length = 0;
};

/// Calls `see(name, content)` for each attribute of a file's first header. Returns the first
/// attribute that is longer than the file, at which it stops.
template <typename See>
LongExrAttribute each_exr_attribute(std::span<const std::uint8_t> bytes, See see) {
  for (std::size_t at = 8; at < bytes.size();) {
    const std::string_view name = exr_text(bytes, at);
    if (name.empty()) break;
    exr_text(bytes, at);  // the type
    if (at > bytes.size() || bytes.size() - at < 4) break;
    const std::size_t length = exr_number(bytes, at);
    at += 4;
    if (length > bytes.size() - at) return {name, length};
    see(name, bytes.subspan(at, length));
    at += length;
  }
  return {};
}

}  // namespace aerostat::image
