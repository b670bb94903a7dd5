#include "png_file.hpp"

#include <algorithm>
#include <cstddef>

#include <zlib.h>

namespace aerostat::elevation {
namespace {

std::string number(std::size_t value) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 255u);
  return text;
}

std::string piece(const std::string& name, const std::string& content) {
  const std::string body = name + content;
  const auto sum =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return number(content.size()) + body + number(sum);
}

}  // namespace

std::string png(int width, int height, int bits, int colour, const std::vector<int>& values) {
  const std::size_t row =
      std::max<std::size_t>(1, values.size() / static_cast<std::size_t>(height));
  std::string raw;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % row == 0) raw += '\0';
    if (bits == 16) raw += static_cast<char>(values[i] >> 8 & 255);
    raw += static_cast<char>(values[i] & 255);
  }
  uLongf length = compressBound(raw.size());
  std::string packed(length, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &length,
           reinterpret_cast<const Bytef*>(raw.data()), raw.size());
  packed.resize(length);
  const std::string header = number(static_cast<std::size_t>(width)) +
                             number(static_cast<std::size_t>(height)) + static_cast<char>(bits) +
                             static_cast<char>(colour) + std::string(3, '\0');
  // A gamma of 1 / 2.2, which heights do not have.
  return "\x89PNG\r\n\x1a\n" + piece("IHDR", header) + piece("gAMA", number(45455)) +
         piece("IDAT", packed) + piece("IEND", "");
}

}  // namespace aerostat::elevation
