#pragma once

#include <cstdint>

#include "camera.h"
#include "render/session.hpp"

namespace aerostat::render {

/// How the lanes of a packet are shared between pixels and samples of one pixel.
struct PacketShape {
  std::uint32_t log2_w = 0, log2_h = 0, log2_samples = 0;
};

/// As many samples of one pixel as `remaining` fills (samples of one pixel are the most coherent
/// rays), the other lanes as square a block of pixels as possible. `lanes` is a power of two.
PacketShape packet_shape(int lanes, int remaining);

/// The work of one launch that gives each pixel of `area` the samples from `first_sample` on, as
/// many as `shape` holds. Blocks begin at the corner of the area: what a pixel becomes does not
/// depend on where that is, since a packet's rays do not influence each other.
AeroTile tile_of(const Crop& area, const PacketShape& shape, std::uint32_t first_sample);

/// The window of a film that holds these pixels of the image.
AeroWindow window_of(const Crop& pixels);

}  // namespace aerostat::render
