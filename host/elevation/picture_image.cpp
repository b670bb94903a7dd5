// Pictures in PNG and JPEG files.
#include <array>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "elevation/bytes.hpp"
#include "elevation/picture.hpp"
#include "elevation/reading.hpp"
#include "image/decode.hpp"

namespace aerostat::elevation {
namespace {

/// A byte of a compressed file makes at most so many pixels: deflate makes 1032 bytes of one.
constexpr std::uint64_t kMostPixelsAByte = 1032 * 8;

using Pixels = std::unique_ptr<std::uint8_t, image::FreeMemory>;

/// A picture whose pixels are all in memory, with 8 bits of red, green, blue and opacity each.
class ImagePicture final : public Picture {
 public:
  ImagePicture(RasterInfo info, Pixels pixels)
      : Picture(info, {{info.width, info.height}}), pixels_(std::move(pixels)) {
    for (int i = 0; i < 256; ++i) albedo_[static_cast<std::size_t>(i)] = albedo_of_srgb(i / 255.0);
  }

  void read(int, const Window& window, vec4* pixels) const override {
    for (int j = 0; j < window.height; ++j) {
      const auto first =
          static_cast<std::size_t>(window.row + j) * static_cast<std::size_t>(info_.width) +
          static_cast<std::size_t>(window.column);
      const std::uint8_t* from = pixels_.get() + 4 * first;
      for (int i = 0; i < window.width; ++i, from += 4) {
        const float opacity = static_cast<float>(from[3]) / 255.0f;
        *pixels++ =
            vec4(opacity * vec3(albedo_[from[0]], albedo_[from[1]], albedo_[from[2]]), opacity);
      }
    }
  }

 private:
  Pixels pixels_;
  std::array<float, 256> albedo_{};
};

}  // namespace

std::unique_ptr<Picture> open_image_picture(const std::filesystem::path& path,
                                            const PictureOptions& options) {
  const std::vector<std::uint8_t> bytes = read_whole(path, kMostPictureBytes);
  RasterInfo info;
  info.path = path;
  info.format = bytes.front() == 0x89 ? "PNG" : "JPEG";
  info.sample_type = "uint8";
  const image::ImageSize size = image::image_size(bytes, info.format, path);
  info.width = size.width;
  info.height = size.height;
  const auto count =
      static_cast<std::uint64_t>(info.width) * static_cast<std::uint64_t>(info.height);
  if (count > kMostPixelsInMemory) {
    refuse(path, fmt::format("the picture has {} x {} pixels, and at most {} of a {} are read; a "
                             "GeoTIFF may have more",
                             info.width, info.height, kMostPixelsInMemory, info.format));
  }
  if (count > (bytes.size() + 1) * kMostPixelsAByte) {
    refuse(path, fmt::format("the file has {} bytes, too few for {} x {} pixels", bytes.size(),
                             info.width, info.height));
  }
  set_picture_place(info, options);
  image::DecodedImage<std::uint8_t> image =
      image::decode_8_bits(bytes, image::Channels::rgba, info.format, path);
  return std::make_unique<ImagePicture>(std::move(info), std::move(image.samples));
}

}  // namespace aerostat::elevation
