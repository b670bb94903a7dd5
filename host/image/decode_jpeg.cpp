// JPEG by libjpeg-turbo.
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <utility>

#include <jerror.h>
#include <jpeglib.h>

#include "image/codecs.hpp"

namespace aerostat::image {
namespace {

constexpr int kMostScans = 100;  // a file of many scans takes long to decode and shows nothing more

/// An image that libjpeg reads from memory. Errors of libjpeg end in the jump buffer, so that the
/// functions that call it hold nothing which a destructor would have to free.
struct JpegInput {
  JpegInput() {
    decoder.err = jpeg_std_error(&errors);
    errors.error_exit = [](j_common_ptr common) { fail(common); };
    // libjpeg would fill up a file that is cut short.
    errors.emit_message = [](j_common_ptr common, int level) {
      if (level < 0 && common->err->msg_code == JWRN_JPEG_EOF) fail(common);
    };
    progress.progress_monitor = [](j_common_ptr common) {
      if (reinterpret_cast<j_decompress_ptr>(common)->input_scan_number <= kMostScans) return;
      auto& self = *static_cast<JpegInput*>(common->client_data);
      std::snprintf(self.reason, sizeof self.reason, "it has more than %d scans", kMostScans);
      std::longjmp(self.jump, 1);
    };
  }
  ~JpegInput() { jpeg_destroy_decompress(&decoder); }
  JpegInput(const JpegInput&) = delete;
  JpegInput& operator=(const JpegInput&) = delete;

  [[noreturn]] static void fail(j_common_ptr common) {
    auto& self = *static_cast<JpegInput*>(common->client_data);
    common->err->format_message(common, self.reason);
    std::longjmp(self.jump, 1);
  }

  jpeg_decompress_struct decoder{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf jump{};
  char reason[JMSG_LENGTH_MAX] = "";
};

bool read_header(JpegInput& input, std::span<const std::uint8_t> bytes, ImageSize& size) {
  if (setjmp(input.jump) != 0) return false;
  jpeg_create_decompress(&input.decoder);
  input.decoder.client_data = &input;
  input.decoder.progress = &input.progress;
  jpeg_mem_src(&input.decoder, bytes.data(), bytes.size());
  jpeg_read_header(&input.decoder, TRUE);
  size.width = static_cast<int>(input.decoder.image_width);
  size.height = static_cast<int>(input.decoder.image_height);
  return true;
}

/// Begins to decode. Returns the channels of a pixel, or 0. Images of four inks keep them.
int begin(JpegInput& input, Channels channels) {
  if (setjmp(input.jump) != 0) return 0;
  jpeg_decompress_struct& decoder = input.decoder;
  const bool inks = decoder.jpeg_color_space == JCS_CMYK || decoder.jpeg_color_space == JCS_YCCK;
  const bool grey = decoder.jpeg_color_space == JCS_GRAYSCALE;
  decoder.out_color_space = inks                         ? JCS_CMYK
                            : channels == Channels::rgba ? JCS_EXT_RGBA
                            : grey                       ? JCS_GRAYSCALE
                                                         : JCS_RGB;
  jpeg_start_decompress(&decoder);
  return decoder.output_components;
}

bool read_rows(JpegInput& input, std::uint8_t* samples) {
  if (setjmp(input.jump) != 0) return false;
  jpeg_decompress_struct& decoder = input.decoder;
  const std::size_t row = static_cast<std::size_t>(decoder.output_width) *
                          static_cast<std::size_t>(decoder.output_components);
  while (decoder.output_scanline < decoder.output_height) {
    JSAMPROW line = samples + decoder.output_scanline * row;
    jpeg_read_scanlines(&decoder, &line, 1);
  }
  return true;
}

/// Turns inks into colours. Files of Adobe's programs store inks inverted.
void inks_to_colours(const std::uint8_t* inks, std::size_t pixels, bool inverted, int channels,
                     std::uint8_t* colours) {
  for (std::size_t i = 0; i < pixels; ++i, inks += 4, colours += channels) {
    const int black = inverted ? inks[3] : 255 - inks[3];
    for (int k = 0; k < 3; ++k) {
      const int ink = inverted ? inks[k] : 255 - inks[k];
      colours[k] = static_cast<std::uint8_t>((ink * black + 127) / 255);
    }
    if (channels == 4) colours[3] = 255;
  }
}

bool decode(JpegInput& input, Channels channels, DecodedImage<std::uint8_t>& image) {
  image.channels = begin(input, channels);
  if (image.channels == 0) return false;
  if (!make_room(image)) {
    std::snprintf(input.reason, sizeof input.reason, "there is no memory for it");
    return false;
  }
  if (!read_rows(input, image.samples.get())) return false;
  if (input.decoder.out_color_space != JCS_CMYK) return true;
  const DecodedImage<std::uint8_t> inks = std::move(image);
  image.width = inks.width;
  image.height = inks.height;
  image.channels = channels == Channels::rgba ? 4 : 3;
  if (!make_room(image)) return false;
  inks_to_colours(inks.samples.get(),
                  static_cast<std::size_t>(inks.width) * static_cast<std::size_t>(inks.height),
                  input.decoder.saw_Adobe_marker == TRUE, image.channels, image.samples.get());
  return true;
}

}  // namespace

bool jpeg_size(std::span<const std::uint8_t> bytes, ImageSize& size, std::string& reason) {
  JpegInput input;
  const bool done = read_header(input, bytes, size);
  reason = input.reason;
  return done;
}

bool decode_jpeg(std::span<const std::uint8_t> bytes, Channels channels,
                 DecodedImage<std::uint8_t>& image, std::string& reason) {
  JpegInput input;
  ImageSize size;
  bool done = read_header(input, bytes, size);
  image.width = size.width;
  image.height = size.height;
  done = done && decode(input, channels, image);
  reason = input.reason;
  if (!done) image.samples.reset();
  return done;
}

}  // namespace aerostat::image
