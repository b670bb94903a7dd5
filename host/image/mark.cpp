#include "image/mark.hpp"

#include <array>
#include <cstddef>
#include <string_view>

#include <zlib.h>

#include "core/error.hpp"

namespace aerostat::image {

namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::string_view kKeyword("aerostat\0", 9);  // with the zero byte that ends it
constexpr std::size_t kHeaderEnd = 8 + 25;             // the signature and IHDR, the first chunk
constexpr std::size_t kChunkFrame = 12;                // length, type and checksum

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::uint32_t big_endian(std::span<const std::uint8_t> bytes) {
  return (std::uint32_t{bytes[0]} << 24) | (std::uint32_t{bytes[1]} << 16) |
         (std::uint32_t{bytes[2]} << 8) | std::uint32_t{bytes[3]};
}

void append_big_endian(std::uint32_t value, std::vector<std::uint8_t>& bytes) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
}

std::uint32_t crc_of(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(
      crc32(crc32(0, nullptr, 0), bytes.data(), static_cast<uInt>(bytes.size())));
}

}  // namespace

void mark_png(std::vector<std::uint8_t>& png, const std::string& mark) {
  if (png.size() < kHeaderEnd || !text_of(png).starts_with(kSignature)) {
    throw Error(ErrorKind::internal, "marking a picture that is no PNG");
  }
  std::vector<std::uint8_t> chunk;
  append_big_endian(static_cast<std::uint32_t>(kKeyword.size() + mark.size()), chunk);
  for (const std::string_view part : {std::string_view("tEXt"), kKeyword, std::string_view(mark)}) {
    chunk.insert(chunk.end(), part.begin(), part.end());
  }
  append_big_endian(crc_of(std::span(chunk).subspan(4)), chunk);
  png.insert(png.begin() + kHeaderEnd, chunk.begin(), chunk.end());
}

MarkedFile mark_of_png(std::span<const std::uint8_t> png) {
  MarkedFile file;
  if (png.size() < kHeaderEnd || !text_of(png).starts_with(kSignature)) return file;
  std::size_t at = kSignature.size();
  while (png.size() - at >= kChunkFrame) {
    const std::size_t length = big_endian(png.subspan(at));
    if (length > png.size() - at - kChunkFrame) return file;
    const auto typed = png.subspan(at + 4, 4 + length);
    if (big_endian(png.subspan(at + 8 + length)) != crc_of(typed)) return file;
    const std::string_view type = text_of(typed.first(4)), data = text_of(typed.subspan(4));
    if (type == "tEXt" && data.starts_with(kKeyword)) file.mark = data.substr(kKeyword.size());
    at += kChunkFrame + length;
    if (type == "IEND") {
      file.is_whole = at == png.size();
      return file;
    }
  }
  return file;
}

}  // namespace aerostat::image
