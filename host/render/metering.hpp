#pragma once

#include <cstdint>

#include "camera.h"

namespace aerostat::render {

/// The most pixels and samples per pixel by which a picture is metered. A smaller picture is
/// metered at all its pixels, and a picture with fewer samples with as many as it has.
/// docs/decisions/0020-metering.md says how near this comes to all pixels and samples.
inline constexpr double kMeteringPixels = 14400.0;
inline constexpr std::uint32_t kMeteringSamples = 4;

/// Returns the frame whose film meters a picture. It divides the whole picture of `frame` into even
/// parts and takes one pixel in the middle of each. It is the same whatever part of the picture is
/// rendered. Its samples are a power of two.
AeroFrame metering_frame(const AeroFrame& frame);

}  // namespace aerostat::render
