#include "image/decode.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "image/codecs.hpp"

namespace aerostat::image {
namespace {

bool is_png(std::span<const std::uint8_t> bytes) {
  return !bytes.empty() && bytes[0] == 0x89;
}

/// Refuses an image. `what` is what could not be done. Bytes of the file that stand in the reason
/// and are no printable ASCII become question marks.
[[noreturn]] void refuse_image(const std::string& what, std::string reason,
                               const std::filesystem::path& path) {
  for (char& c : reason) {
    if (c < ' ' || c > '~') c = '?';
  }
  throw Error(ErrorKind::bad_data, fmt::format("{}: {}: {}", path.string(), what,
                                               reason.empty() ? "no reason is known" : reason));
}

}  // namespace

ImageSize image_size(std::span<const std::uint8_t> bytes, const std::string& format,
                     const std::filesystem::path& path) {
  ImageSize size;
  std::string reason;
  const bool done = is_png(bytes) ? png_size(bytes, size, reason) : jpeg_size(bytes, size, reason);
  if (!done) {
    refuse_image(fmt::format("the header of the {} file cannot be read", format), reason, path);
  }
  return size;
}

DecodedImage<std::uint8_t> decode_8_bits(std::span<const std::uint8_t> bytes, Channels channels,
                                         const std::string& format,
                                         const std::filesystem::path& path) {
  DecodedImage<std::uint8_t> image;
  std::string reason;
  const bool done = is_png(bytes) ? decode_png(bytes, channels, image, reason)
                                  : decode_jpeg(bytes, channels, image, reason);
  if (!done) refuse_image(fmt::format("the {} file cannot be decoded", format), reason, path);
  return image;
}

DecodedImage<std::uint16_t> decode_16_bits(std::span<const std::uint8_t> bytes,
                                           const std::string& format,
                                           const std::filesystem::path& path) {
  DecodedImage<std::uint16_t> image;
  std::string reason;
  if (!decode_png(bytes, image, reason)) {
    refuse_image(fmt::format("the {} file cannot be decoded", format), reason, path);
  }
  return image;
}

}  // namespace aerostat::image
