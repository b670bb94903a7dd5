#include "render/metering.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace aerostat::render {
namespace {

/// Returns the number of parts along a side of `pixels` pixels: `wanted`, but at least one and at
/// most one for each pixel.
std::uint32_t parts_of(double pixels, double wanted) {
  return static_cast<std::uint32_t>(std::clamp(wanted, 1.0, std::min(pixels, kMeteringPixels)));
}

void stretch(aero_float* step, double factor) {
  for (int axis = 0; axis < 3; ++axis) {
    step[axis] = static_cast<float>(double{step[axis]} * factor);
  }
}

}  // namespace

AeroFrame metering_frame(const AeroFrame& frame) {
  const double width = frame.width, height = frame.height;
  AeroFrame metering = frame;
  if (width * height > kMeteringPixels) {
    metering.width = parts_of(width, std::round(std::sqrt(kMeteringPixels * width / height)));
    metering.height = parts_of(height, std::floor(kMeteringPixels / metering.width));
  }
  const double across = width / metering.width, down = height / metering.height;
  stretch(metering.camera.step_x, across);
  stretch(metering.camera.step_y, down);
  metering.sample_spread = static_cast<float>(1.0 / std::max(across, down));
  metering.samples = std::bit_floor(std::min(frame.samples, kMeteringSamples));
  metering.sample_stride = 1;
  return metering;
}

}  // namespace aerostat::render
