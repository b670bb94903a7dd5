#include "image/decode.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS (1 << 20)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace aerostat::image {
namespace {

/// Returns stb's reason for the last failure. Bytes of the file that stand in it and are no
/// printable ASCII become question marks.
std::string reason() {
  const char* const words = stbi_failure_reason();
  std::string text = words == nullptr ? "no reason is known" : words;
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text;
}

/// Refuses an image. `what` is what could not be done.
[[noreturn]] void refuse_image(const std::string& what, const std::filesystem::path& path) {
  throw Error(ErrorKind::bad_data, fmt::format("{}: {}: {}", path.string(), what, reason()));
}

int length_of(std::span<const std::uint8_t> bytes) {
  return static_cast<int>(bytes.size());
}

}  // namespace

ImageSize image_size(std::span<const std::uint8_t> bytes, const std::string& format,
                     const std::filesystem::path& path) {
  ImageSize size;
  int channels = 0;
  if (stbi_info_from_memory(bytes.data(), length_of(bytes), &size.width, &size.height, &channels) ==
      0) {
    refuse_image(fmt::format("the header of the {} file cannot be read", format), path);
  }
  return size;
}

DecodedImage<std::uint8_t> decode_8_bits(std::span<const std::uint8_t> bytes, int channels,
                                         const std::string& format,
                                         const std::filesystem::path& path) {
  DecodedImage<std::uint8_t> image;
  image.samples.reset(stbi_load_from_memory(bytes.data(), length_of(bytes), &image.width,
                                            &image.height, &image.channels, channels));
  if (!image.samples) refuse_image(fmt::format("the {} file cannot be decoded", format), path);
  if (channels > 0) image.channels = channels;
  return image;
}

DecodedImage<std::uint16_t> decode_16_bits(std::span<const std::uint8_t> bytes,
                                           const std::string& format,
                                           const std::filesystem::path& path) {
  DecodedImage<std::uint16_t> image;
  image.samples.reset(stbi_load_16_from_memory(bytes.data(), length_of(bytes), &image.width,
                                               &image.height, &image.channels, 0));
  if (!image.samples) refuse_image(fmt::format("the {} file cannot be decoded", format), path);
  return image;
}

}  // namespace aerostat::image
