#pragma once

#include <filesystem>
#include <optional>

#include "image/write.hpp"

namespace aerostat::test {

/// How two 8-bit pictures of one size differ, in steps of 1/255.
struct PixelDifference {
  double mean = 0.0;      // absolute, over all values
  int percentile_99 = 0;  // 99 of 100 values differ by no more
  int largest = 0;
};

PixelDifference difference(const image::Pixels& a, const image::Pixels& b);

/// |a - b| eight times as bright, to be looked at.
image::Pixels difference_picture(const image::Pixels& a, const image::Pixels& b);

/// A PNG as 8-bit RGB; empty if there is none or it cannot be read.
std::optional<image::Pixels> read_png(const std::filesystem::path& path);

/// Makes the folder if it has to.
void write_png(const std::filesystem::path& path, const image::Pixels& pixels);

}  // namespace aerostat::test
