#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The readers of files of heights and of what lies on real land, as fuzzing calls them.
namespace aerostat::test {

struct ElevationReader {
  const char* name = "";  // of the folder in tests/fuzz/seeds, too
  void (*read)(std::span<const std::uint8_t> bytes) = nullptr;
  int cost = 1;  // how many times as long as with most readers a file takes
};

std::span<const ElevationReader> elevation_readers();

/// Returns what a reader did wrong with bytes, or an empty text. It may return a raster all of
/// whose samples can be read, or refuse the bytes in words that name the file.
std::string fault_of(const ElevationReader& reader, std::span<const std::uint8_t> bytes);

}  // namespace aerostat::test
