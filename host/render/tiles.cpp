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

Tiles::Tiles(const Crop& crop, const PacketShape& shape, std::uint32_t first_sample)
    : crop_(crop), shape_(shape), first_sample_(first_sample), y_(crop.y0) {
  const auto width = static_cast<std::uint32_t>(crop.x1 - crop.x0);
  packets_per_row_ = (width + (1u << shape.log2_w) - 1) >> shape.log2_w;
}

AeroTile Tiles::next(std::uint64_t max_packets) {
  const int block_height = 1 << shape_.log2_h;
  const auto left = static_cast<std::uint64_t>((crop_.y1 - y_ + block_height - 1) / block_height);
  const std::uint64_t rows = std::clamp<std::uint64_t>(max_packets / packets_per_row_, 1, left);
  AeroTile tile{};
  tile.x0 = static_cast<std::uint32_t>(crop_.x0);
  tile.y0 = static_cast<std::uint32_t>(y_);
  tile.x1 = static_cast<std::uint32_t>(crop_.x1);
  y_ = std::min(crop_.y1, y_ + static_cast<int>(rows) * block_height);
  tile.y1 = static_cast<std::uint32_t>(y_);
  tile.blocks_per_row = packets_per_row_;
  tile.block_count = static_cast<std::uint32_t>(rows) * packets_per_row_;
  tile.first_sample = first_sample_;
  tile.log2_w = shape_.log2_w;
  tile.log2_h = shape_.log2_h;
  tile.log2_samples = shape_.log2_samples;
  return tile;
}

}  // namespace aerostat::render
