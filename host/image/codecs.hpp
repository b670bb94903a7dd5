#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "image/decode.hpp"

/// The decoders behind decode.hpp. They return false, with the library's reason, if an image cannot
/// be read. What they allocated is then freed.
namespace aerostat::image {

/// The most pixels along a side that are decoded.
inline constexpr int kMostImageSide = 1 << 20;

bool png_size(std::span<const std::uint8_t> bytes, ImageSize& size, std::string& reason);
bool jpeg_size(std::span<const std::uint8_t> bytes, ImageSize& size, std::string& reason);

bool decode_png(std::span<const std::uint8_t> bytes, Channels channels,
                DecodedImage<std::uint8_t>& image, std::string& reason);
bool decode_png(std::span<const std::uint8_t> bytes, DecodedImage<std::uint16_t>& image,
                std::string& reason);
bool decode_jpeg(std::span<const std::uint8_t> bytes, Channels channels,
                 DecodedImage<std::uint8_t>& image, std::string& reason);

/// Gives an image that has its size and channels room for its samples. Returns whether there was
/// memory for them.
template <class Sample>
bool make_room(DecodedImage<Sample>& image) {
  const std::size_t pixels =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.samples.reset(static_cast<Sample*>(
      std::calloc(pixels * static_cast<std::size_t>(image.channels), sizeof(Sample))));
  return image.samples != nullptr;
}

}  // namespace aerostat::image
