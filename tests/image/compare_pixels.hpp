#pragma once

#include <filesystem>
#include <optional>

#include "image/write.hpp"

namespace aerostat::test {

/// The difference of two 8-bit pictures of the same size, in steps of 1/255.
struct PixelDifference {
  /// The mean absolute difference over all values.
  double mean = 0.0;
  /// A difference that 99 of 100 values do not exceed.
  int percentile_99 = 0;
  int largest = 0;
};

PixelDifference difference(const image::Pixels& a, const image::Pixels& b);

/// Returns |a - b| eight times as bright, for a look at it.
image::Pixels difference_picture(const image::Pixels& a, const image::Pixels& b);

/// Returns a PNG as 8-bit RGB, or nothing if the file does not exist or cannot be read.
std::optional<image::Pixels> read_png(const std::filesystem::path& path);

/// Writes a PNG. Makes its folder if there is none.
void write_png(const std::filesystem::path& path, const image::Pixels& pixels);

}  // namespace aerostat::test
