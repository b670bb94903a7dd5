#include "artwork/picture.hpp"

#include <algorithm>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "artwork/svg.hpp"
#include "asset/files.hpp"
#include "core/error.hpp"
#include "image/decode.hpp"

namespace aerostat::artwork {
namespace {

constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n", kJpeg = "\xff\xd8\xff";

}  // namespace

asset::Texture decode_picture(std::string_view bytes, const std::filesystem::path& file) {
  const bool is_png = bytes.starts_with(kPng);
  if (!is_png && !bytes.starts_with(kJpeg)) {
    throw Error(ErrorKind::bad_data, fmt::format("{}: found a file of another format, expected a "
                                                 "PNG, JPEG or SVG picture",
                                                 file.string()));
  }
  const std::string format = is_png ? "PNG" : "JPEG";
  const std::span<const std::uint8_t> content(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                              bytes.size());
  const image::ImageSize size = image::image_size(content, format, file);
  const auto most = static_cast<int>(kMostPictureSide);
  if (size.width > most || size.height > most) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: found a picture of {} x {} pixels, expected at most {} a side",
                            file.string(), size.width, size.height, most));
  }
  const auto decoded = image::decode_8_bits(content, image::Channels::rgba, format, file);
  asset::Texture texture;
  texture.name = file.string();
  texture.width = static_cast<std::uint32_t>(decoded.width);
  texture.height = static_cast<std::uint32_t>(decoded.height);
  const std::uint8_t* const first = decoded.samples.get();
  texture.rgba.assign(first, first + std::size_t{4} * texture.width * texture.height);
  return texture;
}

Picture read_picture(const std::filesystem::path& file, const DrawingSize& size) {
  const std::string bytes = asset::bytes_of(file, kMostPictureBytes);
  Picture picture;
  picture.is_drawing = is_svg(bytes);
  if (picture.is_drawing) {
    picture.texture = draw_svg(bytes, file, size, picture.notes);
  } else {
    picture.texture = decode_picture(bytes, file);
  }
  return picture;
}

}  // namespace aerostat::artwork
