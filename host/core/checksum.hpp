#pragma once

#include <cstdint>
#include <string_view>

namespace aerostat {

/// Returns the 64-bit FNV-1a hash of `bytes`. It tells damaged bytes from whole ones and names
/// files by their contents. It does not protect against someone who wants a collision. Source:
/// draft-eastlake-fnv.
constexpr std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3u;
  }
  return hash;
}

}  // namespace aerostat
