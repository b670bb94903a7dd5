#include "elevation/tiff_samples.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <system_error>
#include <type_traits>

#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

struct TypeRow {
  const char* name;
  int bits;
  double lowest, highest;
};
constexpr std::array<TypeRow, 13> kTypes{
    {{"bit", 1, 0.0, 1.0},
     {"uint8", 8, 0.0, 255.0},
     {"int8", 8, -128.0, 127.0},
     {"uint16", 16, 0.0, 65535.0},
     {"int16", 16, -32768.0, 32767.0},
     {"uint32", 32, 0.0, 4294967295.0},
     {"int32", 32, -2147483648.0, 2147483647.0},
     {"uint64", 64, 0.0, 18446744073709551615.0},
     {"int64", 64, -9223372036854775808.0, 9223372036854775807.0},
     {"float16", 16, 0.0, 1.0},
     {"float24", 24, 0.0, 1.0},
     {"float32", 32, 0.0, 1.0},
     {"float64", 64, 0.0, 1.0}}};

const TypeRow& row_of(TiffSample type) {
  return kTypes[static_cast<std::size_t>(type)];
}

/// A float with an exponent of E bits and M bits after the point, as IEEE 754 builds them.
template <int E, int M>
struct SmallFloat {
  static constexpr int kBytes = (1 + E + M) / 8;
  static double load(const std::uint8_t* bytes) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, bytes, kBytes);  // little-endian machines only, as everywhere on the host
    const double sign = (bits >> (E + M) & 1u) != 0 ? -1.0 : 1.0;
    const int exponent = static_cast<int>(bits >> M & ((1u << E) - 1));
    const double fraction = std::ldexp(static_cast<double>(bits & ((1u << M) - 1)), -M);
    constexpr int kBias = (1 << (E - 1)) - 1;
    if (exponent == (1 << E) - 1) {
      return fraction == 0.0 ? sign * HUGE_VAL : std::numeric_limits<double>::quiet_NaN();
    }
    if (exponent == 0) return sign * std::ldexp(fraction, 1 - kBias);
    return sign * std::ldexp(1.0 + fraction, exponent - kBias);
  }
};

template <typename T>
struct Plain {
  static constexpr int kBytes = sizeof(T);
  static T load(const std::uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }
};

/// Returns the nodata value as a sample, or nothing if samples cannot have it.
template <typename T>
std::optional<T> nodata_as(const std::string& text) {
  if constexpr (std::is_integral_v<T>) {
    T exact{};
    const char* const end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, exact);
    if (code == std::errc{} && stop == end) return exact;
  }
  const std::optional<double> number = number_of(text);
  if (!number) return std::nullopt;
  if constexpr (std::is_integral_v<T>) {
    constexpr double kLow = static_cast<double>(std::numeric_limits<T>::min());
    // The highest value of 64 bits is not a double, so the next power of two is the bound.
    const double beyond = std::ldexp(1.0, std::numeric_limits<T>::digits);
    if (*number != std::floor(*number) || *number < kLow || *number >= beyond) return std::nullopt;
    return static_cast<T>(*number);
  } else if constexpr (std::is_same_v<T, float>) {
    // Beyond the range, the conversion would be undefined, and infinities are voids anyway.
    if (std::abs(*number) > std::numeric_limits<float>::max()) return std::nullopt;
    return static_cast<float>(*number);
  } else {
    return *number;
  }
}

/// Takes samples one behind the other that are heights in metres. It has no branches, so that many
/// samples are taken at once.
template <typename T, bool kHasMark>
void take_metres(const std::uint8_t* samples, T mark, std::size_t count, float* heights) {
  constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < count; ++i) {
    const T sample = Plain<T>::load(samples + i * sizeof(T));
    const auto value = static_cast<float>(sample);
    const bool is_void = !(std::abs(value) < 1e30f) | (kHasMark && sample == mark);
    heights[i] = is_void ? kVoid : value;
  }
}

template <typename Loader>
void convert(const HeightRule& rule, const std::uint8_t* samples, std::size_t stride,
             std::size_t count, float* heights) {
  using T = decltype(Loader::load(samples));
  T mark{};  // what stands for no height, if anything does
  bool has_mark = false;
  if (rule.nodata) {
    const std::optional<T> known = nodata_as<T>(rule.nodata->text);
    has_mark = known.has_value();
    if (has_mark) mark = *known;
  }
  const std::size_t step = stride * Loader::kBytes;
  constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
  if (sizeof(T) <= 4 && stride == 1 && rule.scale * rule.metres_per_unit == 1.0 &&
      rule.offset == 0.0) {
    return has_mark ? take_metres<T, true>(samples, mark, count, heights)
                    : take_metres<T, false>(samples, mark, count, heights);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const T sample = Loader::load(samples + i * step);
    const double value = static_cast<double>(sample);
    if ((has_mark && sample == mark) || is_no_height(value)) {
      heights[i] = kVoid;
      continue;
    }
    const double height = (value * rule.scale + rule.offset) * rule.metres_per_unit;
    heights[i] = is_no_height(height) ? kVoid : static_cast<float>(height);
  }
}

/// Half floats and those of 24 bits are compared in their own precision.
std::string rounded_to(TiffSample type, const std::string& text) {
  const std::optional<double> number = number_of(text);
  if (!number || !std::isfinite(*number)) return text;
  int exponent = 0;
  const double fraction = std::frexp(*number, &exponent);
  const int digits = type == TiffSample::float16 ? 11 : 17;
  const double rounded =
      std::ldexp(std::nearbyint(std::ldexp(fraction, digits)), exponent - digits);
  std::array<char, 32> buffer{};
  const auto [end, code] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded);
  return code == std::errc{} ? std::string(buffer.data(), end) : text;
}

void convert_bits(const std::uint8_t* samples, std::size_t stride, std::size_t count,
                  float* heights) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t bit = i * stride;
    heights[i] = static_cast<float>(samples[bit / 8] >> (7 - bit % 8) & 1);
  }
}

}  // namespace

const char* name_of(TiffSample type) {
  return row_of(type).name;
}

int bits_of(TiffSample type) {
  return row_of(type).bits;
}

bool is_float(TiffSample type) {
  return type >= TiffSample::float16;
}

double lowest_of(TiffSample type) {
  return row_of(type).lowest;
}

double highest_of(TiffSample type) {
  return row_of(type).highest;
}

bool Nodata::fits(TiffSample type) const {
  const std::optional<double> number = number_of(text);
  if (is_float(type)) return number.has_value();
  return number && *number == std::floor(*number) && *number >= lowest_of(type) &&
         *number <= highest_of(type);
}

void samples_to_heights(const HeightRule& rule, const std::uint8_t* samples, std::size_t stride,
                        std::size_t count, float* heights) {
  const auto with = [&]<typename Loader>(const HeightRule& r, Loader) {
    convert<Loader>(r, samples, stride, count, heights);
  };
  HeightRule small = rule;
  if (rule.nodata && (rule.type == TiffSample::float16 || rule.type == TiffSample::float24)) {
    small.nodata->text = rounded_to(rule.type, rule.nodata->text);
  }
  switch (rule.type) {
    case TiffSample::bit:
      return convert_bits(samples, stride, count, heights);
    case TiffSample::uint8:
      return with(rule, Plain<std::uint8_t>());
    case TiffSample::int8:
      return with(rule, Plain<std::int8_t>());
    case TiffSample::uint16:
      return with(rule, Plain<std::uint16_t>());
    case TiffSample::int16:
      return with(rule, Plain<std::int16_t>());
    case TiffSample::uint32:
      return with(rule, Plain<std::uint32_t>());
    case TiffSample::int32:
      return with(rule, Plain<std::int32_t>());
    case TiffSample::uint64:
      return with(rule, Plain<std::uint64_t>());
    case TiffSample::int64:
      return with(rule, Plain<std::int64_t>());
    case TiffSample::float16:
      return with(small, SmallFloat<5, 10>());
    case TiffSample::float24:
      return with(small, SmallFloat<7, 16>());
    case TiffSample::float32:
      return with(rule, Plain<float>());
    case TiffSample::float64:
      return with(rule, Plain<double>());
  }
}

void undo_float_predictor(std::uint8_t* row, std::size_t count, std::size_t sample_bytes,
                          std::vector<std::uint8_t>& scratch) {
  const std::size_t bytes = count * sample_bytes;
  scratch.resize(bytes);
  std::uint8_t sum = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    sum = static_cast<std::uint8_t>(sum + row[i]);
    scratch[i] = sum;
  }
  for (std::size_t b = 0; b < sample_bytes; ++b) {
    // The most significant byte comes first in the file and last in memory.
    const std::uint8_t* from = scratch.data() + (sample_bytes - 1 - b) * count;
    for (std::size_t i = 0; i < count; ++i) row[i * sample_bytes + b] = from[i];
  }
}

}  // namespace aerostat::elevation
