#include <cstdlib>
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "core/error.hpp"
#include "image/deflate.hpp"
#include "image/write.hpp"

namespace {

/// Compresses data in place of stb's own function, which uses one core. The caller frees the
/// result.
unsigned char* compress(unsigned char* data, int length, int* out_length, int /*quality*/) {
  const auto stream = aerostat::image::deflate({data, static_cast<std::size_t>(length)});
  auto* copy = static_cast<unsigned char*>(std::malloc(stream.size()));
  if (copy == nullptr) return nullptr;
  std::memcpy(copy, stream.data(), stream.size());
  *out_length = static_cast<int>(stream.size());
  return copy;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace aerostat::image {

namespace {

// The largest size for which no product of stb's encoder overflows. The encoder counts in int,
// its output buffer grows by doubling, and incompressible data grow by an eighth.
constexpr std::uint64_t kLargestRawBytes = 900ull << 20;

// Selects the PNG filter "Sub" before any thread encodes. For pictures with grain, it gives files
// as small as a choice for each row, in a fifth of the time.
[[maybe_unused]] const int kFilter = stbi_write_force_png_filter = 1;

struct FreeDeleter {
  void operator()(unsigned char* bytes) const { std::free(bytes); }
};

}  // namespace

bool png_can_hold(int width, int height) {
  const auto row = 3 * static_cast<std::uint64_t>(width) + 1;
  return width > 0 && height > 0 && row * static_cast<std::uint64_t>(height) <= kLargestRawBytes;
}

namespace {

std::vector<std::uint8_t> encoded(std::span<const std::uint8_t> samples, int width, int height,
                                  int channels) {
  const auto wanted = static_cast<std::size_t>(channels) * static_cast<std::size_t>(width) *
                      static_cast<std::size_t>(height);
  if (!png_can_hold(width, height) || samples.size() != wanted || wanted > kLargestRawBytes) {
    throw Error(ErrorKind::internal, fmt::format("encoding a PNG of {} x {} pixels in {} bytes",
                                                 width, height, samples.size()));
  }
  int length = 0;
  const std::unique_ptr<unsigned char, FreeDeleter> png(
      stbi_write_png_to_mem(samples.data(), channels * width, width, height, channels, &length));
  if (!png || length <= 0) {
    throw Error(ErrorKind::internal,
                fmt::format("encoding a PNG of {} x {} pixels failed", width, height));
  }
  return {png.get(), png.get() + length};
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Pixels& pixels) {
  return encoded(pixels.rgb, pixels.width, pixels.height, 3);
}

std::vector<std::uint8_t> encode_png(std::span<const std::uint8_t> rgba, int width, int height) {
  return encoded(rgba, width, height, 4);
}

}  // namespace aerostat::image
