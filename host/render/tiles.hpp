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

/// Cuts a crop into bands of whole rows of packets, for launches of about `samples_per_launch`.
/// What a pixel becomes does not depend on the cut: a packet's rays do not influence each other.
class Tiles {
 public:
  Tiles(const Crop& crop, const PacketShape& shape, std::uint32_t first_sample);

  bool done() const { return y_ >= crop_.y1; }

  /// The next band of at most `max_packets` packets (at least one row of them).
  AeroTile next(std::uint64_t max_packets);

 private:
  Crop crop_;
  PacketShape shape_;
  std::uint32_t first_sample_;
  std::uint32_t packets_per_row_;
  int y_;
};

}  // namespace aerostat::render
