#pragma once

#include <cstdint>
#include <string>

namespace aerostat::elevation {

/// One end of the range of a raster's heights, as stored in the file, before any scale or unit.
struct ExtremeValue {
  double value = 0.0;        // the lowest or the highest
  double next = 0.0;         // the value next to it
  std::uint64_t count = 0;   // samples that have it
  std::uint64_t others = 0;  // samples that have other values
};

/// Returns a sentence that warns of an extreme value which looks like an undeclared mark of voids,
/// or an empty text. It is one of the usual marks (-32768, -32767, -9999, 32767, 65535 and the
/// like), and it is far from all other values. 0 is no mark.
std::string sentinel_warning(const ExtremeValue& extreme);

}  // namespace aerostat::elevation
