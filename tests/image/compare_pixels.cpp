#include "compare_pixels.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image.h>
#pragma GCC diagnostic pop

#include "core/file.hpp"

namespace aerostat::test {
namespace {

int step(const image::Pixels& a, const image::Pixels& b, std::size_t i) {
  return std::abs(static_cast<int>(a.rgb[i]) - static_cast<int>(b.rgb[i]));
}

}  // namespace

PixelDifference difference(const image::Pixels& a, const image::Pixels& b) {
  std::array<std::size_t, 256> histogram{};
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    ++histogram[static_cast<std::size_t>(step(a, b, i))];
    sum += step(a, b, i);
  }
  PixelDifference result;
  result.mean = sum / static_cast<double>(a.rgb.size());
  std::size_t within = 0;
  for (int d = 0; d < 256; ++d) {
    if (histogram[static_cast<std::size_t>(d)] == 0) continue;
    if (100 * within < 99 * a.rgb.size()) result.percentile_99 = d;
    within += histogram[static_cast<std::size_t>(d)];
    result.largest = d;
  }
  return result;
}

image::Pixels difference_picture(const image::Pixels& a, const image::Pixels& b) {
  image::Pixels picture{a.width, a.height, std::vector<std::uint8_t>(a.rgb.size())};
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    picture.rgb[i] = static_cast<std::uint8_t>(std::min(255, 8 * step(a, b, i)));
  }
  return picture;
}

std::optional<image::Pixels> read_png(const std::filesystem::path& path) {
  image::Pixels pixels;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> data(
      stbi_load(path.c_str(), &pixels.width, &pixels.height, &channels, 3), stbi_image_free);
  if (!data) return std::nullopt;
  const auto bytes =
      3 * static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
  pixels.rgb.assign(data.get(), data.get() + bytes);
  return pixels;
}

void write_png(const std::filesystem::path& path, const image::Pixels& pixels) {
  std::filesystem::create_directories(path.parent_path());
  write_file(path, image::encode_png(pixels));
}

}  // namespace aerostat::test
