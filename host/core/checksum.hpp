#pragma once

#include <cstdint>
#include <string_view>

namespace aerostat {

/// FNV-1a of 64 bits: tells damaged bytes from whole ones and names files by their contents; no
/// protection against someone who wants a collision. Source: draft-eastlake-fnv.
constexpr std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3u;
  }
  return hash;
}

}  // namespace aerostat
