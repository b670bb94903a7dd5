#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

/// Decodes images by libpng and libjpeg-turbo. Callers bound the size of an image before they
/// decode it.
namespace aerostat::image {

struct FreeMemory {
  void operator()(void* memory) const { std::free(memory); }
};

/// The samples of an image, row by row, `channels` of them for a pixel.
template <class Sample>
struct DecodedImage {
  int width = 0, height = 0;
  int channels = 0;
  std::unique_ptr<Sample, FreeMemory> samples;
};

struct ImageSize {
  int width = 0, height = 0;
};

/// The channels that a caller wants: as many as the image has, which are grey, grey and opacity,
/// RGB, or RGBA; or RGBA in any case.
enum class Channels { own, rgba };

/// Returns the size that the header of a PNG or JPEG image gives. `format` is its name for
/// messages. Throws Error{bad_data} with the path if the header cannot be read.
ImageSize image_size(std::span<const std::uint8_t> bytes, const std::string& format,
                     const std::filesystem::path& path);

/// Decodes a PNG or JPEG image to samples of 8 bits. Palettes become colours, and fewer bits are
/// scaled to 8. JPEG images of four inks become RGB. Throws Error{bad_data} with the path if it is
/// damaged.
DecodedImage<std::uint8_t> decode_8_bits(std::span<const std::uint8_t> bytes, Channels channels,
                                         const std::string& format,
                                         const std::filesystem::path& path);

/// Decodes a PNG image to samples of 16 bits, as many as it has. Otherwise as decode_8_bits.
DecodedImage<std::uint16_t> decode_16_bits(std::span<const std::uint8_t> bytes,
                                           const std::string& format,
                                           const std::filesystem::path& path);

}  // namespace aerostat::image
