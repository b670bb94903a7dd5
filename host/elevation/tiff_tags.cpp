#include "elevation/tiff_tags.hpp"

#include <algorithm>
#include <cstddef>

namespace aerostat::elevation {
namespace {

constexpr std::uint32_t kMostValues = 1 << 20;

/// The values of a tag in the memory of libtiff.
struct Values {
  TIFFDataType type = TIFF_NOTYPE;
  std::uint32_t count = 0;
  const void* data = nullptr;
};

Values values_of(const TiffHandle& handle, std::uint32_t tag) {
  TIFF* const tiff = handle.get();
  // libtiff makes a field of each tag that it does not know, with a count of 32 bits.
  const TIFFField* const field = TIFFFindField(tiff, tag, TIFF_ANY);
  if (field == nullptr || TIFFFieldPassCount(field) == 0 ||
      TIFFFieldReadCount(field) != TIFF_VARIABLE2) {
    return {};
  }
  Values values;
  void* data = nullptr;
  if (TIFFGetField(tiff, tag, &values.count, &data) == 0 || data == nullptr) return {};
  values.type = TIFFFieldDataType(field);
  values.count = std::min(values.count, kMostValues);
  values.data = data;
  return values;
}

template <typename To, typename From>
std::vector<To> copy(const Values& values) {
  const From* const first = static_cast<const From*>(values.data);
  return std::vector<To>(first, first + values.count);
}

}  // namespace

std::vector<double> doubles_of(const TiffHandle& handle, std::uint32_t tag) {
  const Values values = values_of(handle, tag);
  if (values.type == TIFF_DOUBLE) return copy<double, double>(values);
  if (values.type == TIFF_FLOAT) return copy<double, float>(values);
  return {};
}

std::vector<std::uint16_t> shorts_of(const TiffHandle& handle, std::uint32_t tag) {
  const Values values = values_of(handle, tag);
  if (values.type != TIFF_SHORT) return {};
  return copy<std::uint16_t, std::uint16_t>(values);
}

std::string text_of(const TiffHandle& handle, std::uint32_t tag) {
  const Values values = values_of(handle, tag);
  if (values.type != TIFF_ASCII) return "";
  std::string text(static_cast<const char*>(values.data), values.count);
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

}  // namespace aerostat::elevation
