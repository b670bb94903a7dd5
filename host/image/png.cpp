#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <zlib.h>

#include "core/error.hpp"
#include "image/deflate.hpp"
#include "image/write.hpp"

/// Portable Network Graphics (second edition, ISO/IEC 15948:2003).
namespace aerostat::image {

namespace {

// A chunk's length is 31 bits, and incompressible data grows a little.
constexpr std::uint64_t kLargestRawBytes = 900ull << 20;
// "Sub": of pictures with grain it leaves as little as a choice for each row, in a fifth of the
// time.
constexpr std::uint8_t kFilter = 1;

using Bytes = std::vector<std::uint8_t>;

void put_word(std::uint8_t* to, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) to[i] = static_cast<std::uint8_t>(word >> (24 - 8 * i));
}

/// Begins a chunk; returns where it does.
std::size_t begin_chunk(Bytes& png, std::string_view type) {
  const std::size_t begin = png.size();
  png.insert(png.end(), 4, 0);
  png.insert(png.end(), type.begin(), type.end());
  return begin;
}

void end_chunk(Bytes& png, std::size_t begin) {
  put_word(&png[begin], static_cast<std::uint32_t>(png.size() - begin - 8));
  const uLong sum = crc32(0, &png[begin + 4], static_cast<uInt>(png.size() - begin - 4));
  png.insert(png.end(), 4, 0);
  put_word(&png[png.size() - 4], static_cast<std::uint32_t>(sum));
}

void put_header(Bytes& png, const Pixels& pixels) {
  const std::size_t begin = begin_chunk(png, "IHDR");
  std::array<std::uint8_t, 13> header{};
  put_word(&header[0], static_cast<std::uint32_t>(pixels.width));
  put_word(&header[4], static_cast<std::uint32_t>(pixels.height));
  header[8] = 8;  // bits a sample
  header[9] = 2;  // red, green, blue
  png.insert(png.end(), header.begin(), header.end());
  end_chunk(png, begin);
}

/// Bytes `first` and on of the rows, each of which begins with its filter and holds by how much
/// each byte is more than that of the pixel before.
void filter(const Pixels& pixels, std::size_t first, std::span<std::uint8_t> to) {
  const std::size_t width = 3 * static_cast<std::size_t>(pixels.width);
  std::size_t row = first / (width + 1), column = first % (width + 1);
  for (auto out = to.begin(); out != to.end(); ++row, column = 0) {
    const std::uint8_t* from = pixels.rgb.data() + row * width;
    const auto end = std::min(width + 1, column + static_cast<std::size_t>(to.end() - out));
    if (column == 0) {
      *out++ = kFilter;
      ++column;
    }
    for (; column < std::min<std::size_t>(end, 4); ++column) *out++ = from[column - 1];
    for (; column < end; ++column)
      *out++ = static_cast<std::uint8_t>(from[column - 1] - from[column - 4]);
  }
}

}  // namespace

bool png_can_hold(int width, int height) {
  const auto row = 3 * static_cast<std::uint64_t>(width) + 1;
  return width > 0 && height > 0 && row * static_cast<std::uint64_t>(height) <= kLargestRawBytes;
}

std::vector<std::uint8_t> encode_png(const Pixels& pixels) {
  const std::size_t row = 3 * static_cast<std::size_t>(pixels.width);
  const auto height = static_cast<std::size_t>(pixels.height);
  if (!png_can_hold(pixels.width, pixels.height) || pixels.rgb.size() != row * height) {
    throw Error(ErrorKind::internal, fmt::format("encoding a PNG of {} x {} pixels in {} bytes",
                                                 pixels.width, pixels.height, pixels.rgb.size()));
  }
  Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  put_header(png, pixels);
  const std::size_t data = begin_chunk(png, "IDAT");
  append_deflated(
      png, (row + 1) * height,
      [&pixels](std::size_t first, std::span<std::uint8_t> part) { filter(pixels, first, part); });
  end_chunk(png, data);
  end_chunk(png, begin_chunk(png, "IEND"));
  return png;
}

}  // namespace aerostat::image
