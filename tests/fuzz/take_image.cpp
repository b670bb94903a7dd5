#include "take_image.hpp"

#include <cstddef>
#include <exception>
#include <string_view>

#include "artwork/picture.hpp"
#include "artwork/svg.hpp"
#include "core/error.hpp"
#include "image/bands.hpp"
#include "image/decode.hpp"
#include "image/mark.hpp"

namespace aerostat::test {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr const char* kPath = "/nowhere/fuzz";
/// Larger pictures are allowed, but take too long to try many of them.
constexpr std::int64_t kMostPixels = 1 << 20;

bool is_small(const image::ImageSize& size) {
  return std::int64_t{size.width} * size.height <= kMostPixels;
}

template <typename Sample>
std::string fault_of(const image::DecodedImage<Sample>& image, const image::ImageSize& size) {
  if (image.width != size.width || image.height != size.height) return "an image of another size";
  if (image.channels < 1 || image.channels > 4) return "an impossible number of channels";
  const std::size_t count = static_cast<std::size_t>(image.width) *
                            static_cast<std::size_t>(image.height) *
                            static_cast<std::size_t>(image.channels);
  std::uint64_t sum = 0;  // every sample is there
  for (std::size_t i = 0; i < count; ++i) sum += image.samples.get()[i];
  return sum <= std::uint64_t{count} * 65535 ? "" : "impossible samples";
}

std::string decode(const std::string& format, Bytes bytes) {
  const image::ImageSize size = image::image_size(bytes, format, kPath);
  if (size.width < 1 || size.height < 1) return "an image without pixels";
  if (!is_small(size)) return "";
  for (const image::Channels channels : {image::Channels::own, image::Channels::rgba}) {
    const std::string fault = fault_of(image::decode_8_bits(bytes, channels, format, kPath), size);
    if (!fault.empty()) return fault;
  }
  if (format != "PNG") return "";
  return fault_of(image::decode_16_bits(bytes, format, kPath), size);
}

std::string take_artwork(Bytes bytes, bool& is_read) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (artwork::is_svg(text)) {
    is_read = true;
    const auto reference = artwork::first_reference(text);
    return reference && (reference->empty() || reference->size() > 100) ? "a bad reference" : "";
  }
  for (const char* format : {"PNG", "JPEG"}) {
    try {
      if (!is_small(image::image_size(bytes, format, kPath))) return "";
    } catch (const Error&) {
      continue;  // it is of another format
    }
  }
  const asset::Texture texture = artwork::decode_picture(text, kPath);
  is_read = true;
  return texture.rgba.size() == std::size_t{4} * texture.width * texture.height
             ? ""
             : "a texture of another size";
}

std::string take_band(Bytes bytes, bool& is_read) {
  const auto band = image::decode_band(bytes);
  is_read = band.has_value();
  if (!is_read) return "";
  const image::Film& film = band->film;
  const auto pixels = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  const bool is_whole = film.radiance.size() == pixels && film.alpha.size() == pixels &&
                        film.distance_m.size() == pixels && film.samples.size() == pixels;
  if (!is_whole) return "layers of another size";
  return image::mark_of_exr(bytes).is_whole ? "" : "a band that is read and not whole";
}

std::string take(const std::string& reader, Bytes bytes, bool& is_read) {
  if (reader == "artwork") return take_artwork(bytes, is_read);
  if (reader == "band") return take_band(bytes, is_read);
  if (reader == "mark") {
    is_read = image::mark_of_png(bytes).is_whole || image::mark_of_exr(bytes).is_whole;
    return "";
  }
  const std::string fault = decode(reader == "png" ? "PNG" : "JPEG", bytes);
  is_read = true;
  return fault;
}

}  // namespace

const std::vector<std::string>& image_readers() {
  static const std::vector<std::string> readers = {"png", "jpeg", "artwork", "band", "mark"};
  return readers;
}

std::string fault_of_image(const std::string& reader, Bytes bytes, bool& is_read) {
  is_read = false;
  try {
    return take(reader, bytes, is_read);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_data) return std::string("another error: ") + error.what();
    return std::string_view(error.what()).find(kPath) == std::string_view::npos
               ? std::string("an error without the name: ") + error.what()
               : "";
  } catch (const std::exception& error) {
    return std::string("not an error of aerostat's own: ") + error.what();
  }
}

}  // namespace aerostat::test
