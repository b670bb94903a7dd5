#include "elevation/sample_raster.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

struct NamedType {
  SampleType type;
  const char* name;
  int bytes;
};
constexpr std::array kTypes{
    NamedType{SampleType::uint8, "uint8", 1},     NamedType{SampleType::int8, "int8", 1},
    NamedType{SampleType::uint16, "uint16", 2},   NamedType{SampleType::int16, "int16", 2},
    NamedType{SampleType::uint32, "uint32", 4},   NamedType{SampleType::int32, "int32", 4},
    NamedType{SampleType::float32, "float32", 4}, NamedType{SampleType::float64, "float64", 8}};

template <typename T>
T sample_at(const std::uint8_t* bytes, bool swapped) {
  std::array<std::uint8_t, sizeof(T)> copy;
  std::memcpy(copy.data(), bytes, sizeof(T));
  if (swapped) std::reverse(copy.begin(), copy.end());
  return std::bit_cast<T>(copy);
}

template <typename T>
void decode(std::span<const std::uint8_t> bytes, const SampleLayout& layout, float* heights) {
  const bool swapped = layout.big_endian != (std::endian::native == std::endian::big);
  for (std::size_t i = 0; i < bytes.size() / sizeof(T); ++i) {
    const auto stored = static_cast<double>(sample_at<T>(bytes.data() + i * sizeof(T), swapped));
    bool is_void = std::is_floating_point_v<T> && is_no_height(stored);
    for (const double mark : layout.voids) {
      is_void |= std::is_same_v<T, float> ? is_mark(stored, mark) : stored == mark;
    }
    heights[i] = is_void ? std::numeric_limits<float>::quiet_NaN()
                         : static_cast<float>(layout.scale * stored + layout.offset_m);
  }
}

void decode_any(std::span<const std::uint8_t> bytes, const SampleLayout& layout, float* heights) {
  switch (layout.type) {
    case SampleType::uint8:
      return decode<std::uint8_t>(bytes, layout, heights);
    case SampleType::int8:
      return decode<std::int8_t>(bytes, layout, heights);
    case SampleType::uint16:
      return decode<std::uint16_t>(bytes, layout, heights);
    case SampleType::int16:
      return decode<std::int16_t>(bytes, layout, heights);
    case SampleType::uint32:
      return decode<std::uint32_t>(bytes, layout, heights);
    case SampleType::int32:
      return decode<std::int32_t>(bytes, layout, heights);
    case SampleType::float32:
      return decode<float>(bytes, layout, heights);
    case SampleType::float64:
      return decode<double>(bytes, layout, heights);
  }
}

}  // namespace

std::optional<SampleType> sample_type_of(std::string_view name) {
  for (const NamedType& known : kTypes) {
    if (name == known.name) return known.type;
  }
  return std::nullopt;
}

const char* name_of(SampleType type) {
  return kTypes[static_cast<std::size_t>(type)].name;
}

int bytes_of(SampleType type) {
  return kTypes[static_cast<std::size_t>(type)].bytes;
}

SampleRaster::SampleRaster(RasterInfo info, std::shared_ptr<const ByteSource> bytes,
                           SampleLayout layout)
    : Raster(std::move(info)), bytes_(std::move(bytes)), layout_(std::move(layout)) {}

void SampleRaster::read(const Window& window, float* heights) const {
  constexpr std::size_t kPortion = std::size_t{1} << 22;
  const auto width = static_cast<std::size_t>(window.width);
  const auto sample = static_cast<std::size_t>(bytes_of(layout_.type));
  const std::size_t row_bytes = width * sample;
  const std::size_t rows_at_once =
      std::max<std::size_t>(1, kPortion / std::max<std::size_t>(1, row_bytes));
  std::vector<std::uint8_t> portion;
  for (std::size_t j = 0; j < static_cast<std::size_t>(window.height); j += rows_at_once) {
    const std::size_t rows = std::min(rows_at_once, static_cast<std::size_t>(window.height) - j);
    portion.resize(rows * row_bytes);
    const std::uint64_t row = static_cast<std::uint64_t>(window.row) + j;
    bytes_->read(layout_.first + row * layout_.row_stride +
                     static_cast<std::uint64_t>(window.column) * sample,
                 layout_.row_stride, rows, portion);
    decode_any(portion, layout_, heights + j * width);
  }
}

}  // namespace aerostat::elevation
