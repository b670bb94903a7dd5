// PNG by libpng.
#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <vector>

#include <png.h>

#include "image/codecs.hpp"

namespace aerostat::image {
namespace {

constexpr png_alloc_size_t kMostChunkBytes = 8u << 20;  // of texts, profiles and the like
constexpr png_uint_32 kMostKeptChunks = 64;

/// An image that libpng reads from memory. Errors of libpng end in its jump buffer, so that the
/// functions that call it hold nothing which a destructor would have to free.
struct PngInput {
  explicit PngInput(std::span<const std::uint8_t> all) : bytes(all) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &fail, &pass_over);
    if (png != nullptr) info = png_create_info_struct(png);
  }
  ~PngInput() { png_destroy_read_struct(&png, &info, nullptr); }
  PngInput(const PngInput&) = delete;
  PngInput& operator=(const PngInput&) = delete;

  bool is_ready() const { return png != nullptr && info != nullptr; }

  static void read(png_structp png, png_bytep to, png_size_t count) {
    auto& self = *static_cast<PngInput*>(png_get_io_ptr(png));
    if (count > self.bytes.size()) png_error(png, "the file is cut short");
    std::memcpy(to, self.bytes.data(), count);
    self.bytes = self.bytes.subspan(count);
  }

  [[noreturn]] static void fail(png_structp png, png_const_charp message) {
    auto& self = *static_cast<PngInput*>(png_get_error_ptr(png));
    std::strncpy(self.reason, message, sizeof self.reason - 1);
    png_longjmp(png, 1);
  }

  static void pass_over(png_structp, png_const_charp) {}

  std::span<const std::uint8_t> bytes;
  png_structp png = nullptr;
  png_infop info = nullptr;
  char reason[120] = "";
};

/// Reads the header of an image. Returns whether it could be read.
bool read_header(PngInput& input, ImageSize& size) {
  if (setjmp(png_jmpbuf(input.png)) != 0) return false;
  png_set_read_fn(input.png, &input, &PngInput::read);
  png_set_user_limits(input.png, kMostImageSide, kMostImageSide);
  png_set_chunk_malloc_max(input.png, kMostChunkBytes);
  png_set_chunk_cache_max(input.png, kMostKeptChunks);
  png_read_info(input.png, input.info);
  size.width = static_cast<int>(png_get_image_width(input.png, input.info));
  size.height = static_cast<int>(png_get_image_height(input.png, input.info));
  return true;
}

/// Says in which form samples are wanted. Returns how many channels a pixel then has, or 0.
int choose_form(PngInput& input, int bits, Channels channels) {
  if (setjmp(png_jmpbuf(input.png)) != 0) return 0;
  png_set_expand(input.png);
  if (bits == 16) {
    png_set_expand_16(input.png);
    if (std::endian::native == std::endian::little) png_set_swap(input.png);
  } else {
    png_set_strip_16(input.png);
  }
  if (channels == Channels::rgba) {
    png_set_gray_to_rgb(input.png);
    png_set_add_alpha(input.png, 0xff, PNG_FILLER_AFTER);
  }
  png_set_interlace_handling(input.png);
  png_read_update_info(input.png, input.info);
  return png_get_channels(input.png, input.info);
}

bool read_rows(PngInput& input, png_bytepp rows) {
  if (setjmp(png_jmpbuf(input.png)) != 0) return false;
  png_read_image(input.png, rows);
  return true;
}

template <class Sample>
bool decode(std::span<const std::uint8_t> bytes, Channels channels, DecodedImage<Sample>& image,
            std::string& reason) {
  PngInput input(bytes);
  reason = "there is no memory for it";
  if (!input.is_ready()) return false;
  ImageSize size;
  const bool has_header = read_header(input, size);
  image.width = size.width;
  image.height = size.height;
  image.channels = has_header ? choose_form(input, 8 * sizeof(Sample), channels) : 0;
  if (image.channels > 0 && !make_room(image)) return false;
  bool done = false;
  if (image.channels > 0) {
    const std::size_t row =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    std::vector<png_bytep> rows(static_cast<std::size_t>(image.height));
    for (std::size_t y = 0; y < rows.size(); ++y) {
      rows[y] = reinterpret_cast<png_bytep>(image.samples.get() + y * row);
    }
    done = png_get_rowbytes(input.png, input.info) == row * sizeof(Sample) &&
           read_rows(input, rows.data());
  }
  reason = input.reason;
  if (!done) image.samples.reset();
  return done;
}

}  // namespace

bool png_size(std::span<const std::uint8_t> bytes, ImageSize& size, std::string& reason) {
  PngInput input(bytes);
  if (!input.is_ready()) return false;
  const bool done = read_header(input, size);
  reason = input.reason;
  return done;
}

bool decode_png(std::span<const std::uint8_t> bytes, Channels channels,
                DecodedImage<std::uint8_t>& image, std::string& reason) {
  return decode(bytes, channels, image, reason);
}

bool decode_png(std::span<const std::uint8_t> bytes, DecodedImage<std::uint16_t>& image,
                std::string& reason) {
  return decode(bytes, Channels::own, image, reason);
}

}  // namespace aerostat::image
