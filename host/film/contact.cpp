#include "film/contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "film/frame_files.hpp"
#include "image/sheet.hpp"

namespace aerostat::film {
namespace {

constexpr std::size_t kMostTiles = 24;
constexpr int kTileWidth = 320;
constexpr int kRgb = 3;

}  // namespace

std::vector<int> sheet_frames(const std::vector<int>& frames) {
  if (frames.size() <= kMostTiles) return frames;
  std::vector<int> chosen;
  for (std::size_t i = 0; i < kMostTiles; ++i) {
    chosen.push_back(frames[i * (frames.size() - 1) / (kMostTiles - 1)]);
  }
  return chosen;
}

image::Pixels shrunk(const image::Pixels& pixels, int width, int height) {
  image::Pixels small{width, height, {}};
  for (int y = 0; y < height; ++y) {
    const int top = y * pixels.height / height, bottom = (y + 1) * pixels.height / height;
    for (int x = 0; x < width; ++x) {
      const int left = x * pixels.width / width, right = (x + 1) * pixels.width / width;
      for (int channel = 0; channel < kRgb; ++channel) {
        int sum = 0;
        for (int row = top; row < bottom; ++row) {
          for (int column = left; column < right; ++column) {
            sum +=
                pixels
                    .rgb[static_cast<std::size_t>(kRgb * (row * pixels.width + column) + channel)];
          }
        }
        const int count = (bottom - top) * (right - left);
        small.rgb.push_back(static_cast<std::uint8_t>((sum + count / 2) / count));
      }
    }
  }
  return small;
}

image::Pixels contact_sheet(const FrameNames& names, const std::vector<int>& frames) {
  std::vector<image::Pixels> tiles;
  for (const int frame : frames) {
    const image::Pixels whole = pixels_of(names.name(frame));
    const int width = std::min(kTileWidth, whole.width);
    const int height = std::max(
        1, static_cast<int>(std::lround(static_cast<double>(width) * whole.height / whole.width)));
    tiles.push_back(shrunk(whole, width, height));
  }
  image::Sheet sheet(
      image::layout_sheet(static_cast<int>(tiles.size()), tiles[0].width, tiles[0].height));
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    sheet.place(static_cast<int>(i), tiles[i], std::to_string(frames[i]));
  }
  return sheet.pixels();
}

}  // namespace aerostat::film
