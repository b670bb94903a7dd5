#include "render/tiles.hpp"

#include <algorithm>
#include <bit>

namespace aerostat::render {

PacketShape packet_shape(int lanes, int remaining) {
  const auto log2_lanes = static_cast<std::uint32_t>(std::bit_width(unsigned(lanes)) - 1);
  const auto log2_left = static_cast<std::uint32_t>(std::bit_width(unsigned(remaining)) - 1);
  PacketShape shape;
  shape.log2_samples = std::min(log2_lanes, log2_left);
  const std::uint32_t log2_pixels = log2_lanes - shape.log2_samples;
  shape.log2_h = log2_pixels / 2;
  shape.log2_w = log2_pixels - shape.log2_h;
  return shape;
}

AeroTile tile_of(const Crop& area, const PacketShape& shape, std::uint32_t first_sample) {
  const auto blocks = [](int pixels, std::uint32_t log2_size) {
    return (static_cast<std::uint32_t>(pixels) + (1u << log2_size) - 1) >> log2_size;
  };
  AeroTile tile{};
  tile.x0 = static_cast<std::uint32_t>(area.x0);
  tile.y0 = static_cast<std::uint32_t>(area.y0);
  tile.x1 = static_cast<std::uint32_t>(area.x1);
  tile.y1 = static_cast<std::uint32_t>(area.y1);
  tile.blocks_per_row = blocks(area.x1 - area.x0, shape.log2_w);
  tile.block_count = tile.blocks_per_row * blocks(area.y1 - area.y0, shape.log2_h);
  tile.first_sample = first_sample;
  tile.log2_w = shape.log2_w;
  tile.log2_h = shape.log2_h;
  tile.log2_samples = shape.log2_samples;
  return tile;
}

AeroWindow window_of(const Crop& pixels) {
  return {static_cast<std::uint32_t>(pixels.x0), static_cast<std::uint32_t>(pixels.y0),
          static_cast<std::uint32_t>(pixels.x1 - pixels.x0),
          static_cast<std::uint32_t>(pixels.y1 - pixels.y0)};
}

}  // namespace aerostat::render
