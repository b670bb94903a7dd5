#pragma once

#include <cstdint>

#include "camera.h"

namespace aerostat::render {

/// A picture is metered at so many of its pixels, or at all if it has fewer, by so many samples
/// each, or by as many as a pixel takes. docs/decisions/0020-metering.md says how near that comes
/// to all pixels and samples.
inline constexpr double kMeteringPixels = 14400.0;
inline constexpr std::uint32_t kMeteringSamples = 4;

/// The frame by whose film a picture is metered: all that `frame` shows in even parts, of each part
/// a pixel in the middle. It is the same whatever part of the picture is rendered. Its samples are
/// a power of two.
AeroFrame metering_frame(const AeroFrame& frame);

}  // namespace aerostat::render
