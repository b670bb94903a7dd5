#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "asset/reading.hpp"
#include "asset/words.hpp"
#include "image/decode.hpp"

namespace aerostat::asset {
namespace {

using namespace std::string_view_literals;

/// The grey of what a missing texture would have coloured, chosen by eye.
constexpr float kMissingTextureGrey = 0.4f;

/// The grey of what has no material, chosen by eye.
constexpr float kPlainGrey = 0.5f;

/// The most bytes of an encoded picture. The decoder counts them in an int.
constexpr std::size_t kMostPictureBytes = 0x7fffffff;

/// How the files of a format begin.
struct Signature {
  std::string_view format;
  std::string_view bytes;
  std::size_t offset = 0;
};

constexpr std::array<Signature, 10> kSignatures = {{{"PNG", "\x89PNG\r\n\x1a\n"},
                                                    {"JPEG", "\xff\xd8\xff"},
                                                    {"KTX2", "\xabKTX 20\xbb"},
                                                    {"KTX", "\xabKTX 11\xbb"},
                                                    {"WebP", "WEBP", 8},
                                                    {"AVIF", "ftypavif", 4},
                                                    {"DDS", "DDS "},
                                                    {"GIF", "GIF8"},
                                                    {"TIFF", "II*\0"sv},
                                                    {"BMP", "BM"}}};

std::string_view format_of_picture(std::string_view bytes) {
  for (const Signature& signature : kSignatures) {
    const bool is_long = bytes.size() >= signature.offset + signature.bytes.size();
    if (is_long && bytes.substr(signature.offset).starts_with(signature.bytes)) {
      return signature.format;
    }
  }
  return {};
}

}  // namespace

std::size_t add_texture(Reading& reading, std::string_view bytes, const std::string& name) {
  const std::string format(format_of_picture(bytes));
  if (format != "PNG" && format != "JPEG") {
    const std::string found = format.empty() ? "a picture of unknown format" : "a " + format;
    refuse(fmt::format("{}: found {}, expected a PNG or JPEG", name, found));
  }
  if (bytes.size() > kMostPictureBytes) {
    refuse(fmt::format("{}: found {} bytes, expected at most {} of a picture", name, bytes.size(),
                       kMostPictureBytes));
  }
  const std::span<const std::uint8_t> content(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                              bytes.size());
  const image::ImageSize size = image::image_size(content, format, name);
  reading.budget.take_texture(static_cast<std::uint64_t>(size.width),
                              static_cast<std::uint64_t>(size.height));
  const auto decoded = image::decode_8_bits(content, image::Channels::rgba, format, name);
  Texture texture;
  texture.name = name;
  texture.width = static_cast<std::uint32_t>(decoded.width);
  texture.height = static_cast<std::uint32_t>(decoded.height);
  const std::uint8_t* const first = decoded.samples.get();
  texture.rgba.assign(first, first + std::size_t{4} * texture.width * texture.height);
  reading.model.textures.push_back(std::move(texture));
  return reading.model.textures.size() - 1;
}

Texture white_texture(std::uint32_t width, std::uint32_t height) {
  return {"white", width, height,
          std::vector<std::uint8_t>(std::size_t{4} * width * height, std::uint8_t{255})};
}

std::uint8_t least_opacity(const Texture& texture) {
  std::uint8_t least = 255;
  for (std::size_t i = 3; i < texture.rgba.size(); i += 4) least = std::min(least, texture.rgba[i]);
  return least;
}

void set_opacity(Texture& texture, const Texture& from) {
  const std::size_t channel = least_opacity(from) < 255 ? 3 : 0;
  for (std::size_t y = 0; y < texture.height; ++y) {
    const std::size_t from_row = y * from.height / texture.height * from.width;
    for (std::size_t x = 0; x < texture.width; ++x) {
      const std::size_t from_pixel = from_row + x * from.width / texture.width;
      texture.rgba[4 * (y * texture.width + x) + 3] = from.rgba[4 * from_pixel + channel];
    }
  }
}

Material plain_material() {
  Material material;
  material.base_color = glm::vec4(kPlainGrey, kPlainGrey, kPlainGrey, 1.0f);
  material.double_sided = true;
  return material;
}

void show_missing_texture(Material& material) {
  for (int i = 0; i < 3; ++i) material.base_color[i] *= kMissingTextureGrey;
}

float linear_of_srgb(float encoded) {
  if (!(encoded > 0.04045f)) return encoded / 12.92f;
  return std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace aerostat::asset
