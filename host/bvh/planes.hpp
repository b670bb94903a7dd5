#pragma once

#include <cstring>
#include <limits>

#include "box.hpp"
#include "core/simd.hpp"

/// These functions handle boxes as single vectors (lo.xyz, 0, -hi.xyz, 0) for the builder's
/// innermost loops. The union of two boxes is one minimum. All functions are inlined into loops
/// that are compiled for several vector widths. kWide tells whether the processor has vectors of
/// eight floats.
namespace aerostat::bvh {

using Float8 = float __attribute__((vector_size(32), aligned(32)));
using Int8 = std::int32_t __attribute__((vector_size(32), aligned(32)));

inline constexpr std::int32_t kSignBit = std::numeric_limits<std::int32_t>::min();

AEROSTAT_INLINE Float4 low_half(const Float8& v) {
  return __builtin_shufflevector(v, v, 0, 1, 2, 3);
}
AEROSTAT_INLINE Float4 high_half(const Float8& v) {
  return __builtin_shufflevector(v, v, 4, 5, 6, 7);
}
AEROSTAT_INLINE Float8 joined(Float4 low, Float4 high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

AEROSTAT_INLINE Float8 no_planes() {
  return Float8{} + kInfinity;
}

/// Returns the planes of the box around both boxes.
template <bool kWide>
AEROSTAT_INLINE Float8 united(const Float8& a, const Float8& b) {
  // Without vectors of eight floats, the compiler would compare one number at a time.
  if constexpr (!kWide)
    return joined(min4(low_half(a), low_half(b)), min4(high_half(a), high_half(b)));
  return a < b ? a : b;
}

/// Reads the box of a record in the layout that load_box describes.
template <typename Record>
AEROSTAT_INLINE Float8 load_planes(const Record& record) {
  static_assert(sizeof(Record) == 32);
  const Int8 keep{-1, -1, -1, 0, -1, -1, -1, 0};
  const Int8 negate{0, 0, 0, 0, kSignBit, kSignBit, kSignBit, 0};
  Int8 bits;
  std::memcpy(&bits, &record, sizeof(bits));
  return reinterpret_cast<Float8>((bits & keep) ^ negate);
}

AEROSTAT_INLINE Float4 half_centre(const Float8& planes) {
  return low_half(planes) * 0.25f - high_half(planes) * 0.25f;
}

AEROSTAT_INLINE Box to_box(const Float8& planes) {
  Box box;
  box.lo = low_half(planes);
  box.hi = -high_half(planes);
  return box;
}

AEROSTAT_INLINE Float4 size_of(const Float8& planes) {
  return -high_half(planes) - low_half(planes);
}

/// Returns half of the surface areas of four boxes. The area of an empty box is infinite.
AEROSTAT_INLINE Float4 half_areas(const Float8& a, const Float8& b, const Float8& c,
                                  const Float8& d) {
  const Float4 size[4] = {size_of(a), size_of(b), size_of(c), size_of(d)};
  const Float4 xy[2] = {__builtin_shufflevector(size[0], size[1], 0, 4, 1, 5),
                        __builtin_shufflevector(size[2], size[3], 0, 4, 1, 5)};
  const Float4 z_[2] = {__builtin_shufflevector(size[0], size[1], 2, 6, 3, 7),
                        __builtin_shufflevector(size[2], size[3], 2, 6, 3, 7)};
  const Float4 x = __builtin_shufflevector(xy[0], xy[1], 0, 1, 4, 5);
  const Float4 y = __builtin_shufflevector(xy[0], xy[1], 2, 3, 6, 7);
  const Float4 z = __builtin_shufflevector(z_[0], z_[1], 0, 1, 4, 5);
  return x * (y + z) + y * z;
}

/// Returns half of the surface area of one box. The area of an empty box is infinite.
AEROSTAT_INLINE float half_area(const Float8& planes) {
  const Float4 size = size_of(planes);
  return size[0] * (size[1] + size[2]) + size[1] * size[2];
}

}  // namespace aerostat::bvh
