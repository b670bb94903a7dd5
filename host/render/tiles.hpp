#pragma once

#include <cstdint>

#include "camera.h"
#include "render/session.hpp"

namespace aerostat::render {

/// The numbers of pixels and of samples of one pixel that share the lanes of a packet.
struct PacketShape {
  std::uint32_t log2_w = 0, log2_h = 0, log2_samples = 0;
};

/// Returns the shape of a packet of `lanes` lanes, which is a power of two. It has as many samples
/// of one pixel as `remaining` fills, because these rays are the most coherent. The other lanes are
/// a block of pixels that is as square as possible.
PacketShape packet_shape(int lanes, int remaining);

/// Returns the work of one launch. It gives each pixel of `area` as many samples as `shape` holds,
/// from `first_sample` on. Blocks begin at the corner of the area. The result of a pixel does not
/// depend on that corner, because the rays of a packet do not influence each other.
AeroTile tile_of(const Crop& area, const PacketShape& shape, std::uint32_t first_sample);

/// Returns the window of a film that holds these pixels of the image.
AeroWindow window_of(const Crop& pixels);

}  // namespace aerostat::render
