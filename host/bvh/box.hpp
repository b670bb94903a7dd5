#pragma once

#include <cstdint>
#include <cstring>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "core/math.hpp"

/// These functions handle boxes as vectors of four floats for the builder's inner loops. The
/// fourth lane is always ignored.
namespace aerostat::bvh {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 broadcast(float value) {
  return Float4{value, value, value, value};
}

// A vector `a < b ? a : b` compiles to a comparison and a blend. SSE has a single instruction for
// it.
#ifdef __SSE2__
inline Float4 min4(Float4 a, Float4 b) {
  return _mm_min_ps(a, b);
}
inline Float4 max4(Float4 a, Float4 b) {
  return _mm_max_ps(a, b);
}
#else
inline Float4 min4(Float4 a, Float4 b) {
  return a < b ? a : b;
}
inline Float4 max4(Float4 a, Float4 b) {
  return a > b ? a : b;
}
#endif

/// An axis-aligned box, which is empty at first.
struct Box {
  Float4 lo = broadcast(kInfinity);
  Float4 hi = broadcast(-kInfinity);

  void grow(Float4 point) {
    lo = min4(lo, point);
    hi = max4(hi, point);
  }
  void grow(const Box& other) {
    lo = min4(lo, other.lo);
    hi = max4(hi, other.hi);
  }
  /// Returns half of the surface area. The result is meaningless for an empty box.
  float half_area() const {
    const Float4 d = hi - lo;
    return d[0] * (d[1] + d[2]) + d[1] * d[2];
  }
  /// Returns half of the centre. Differences of two half centres never overflow.
  Float4 half_centre() const { return lo * 0.25f + hi * 0.25f; }
  int widest_axis() const {
    const Float4 d = hi - lo;
    const int xy = d[0] >= d[1] ? 0 : 1;
    return d[xy] >= d[2] ? xy : 2;
  }
};

/// Reads the box of a 32-byte record { float lo[3]; <4 bytes>; float hi[3]; <4 bytes> }. The four
/// other bytes are set to zero. As floats, small integers would be subnormal numbers, which are
/// slow to multiply.
template <typename Record>
Box load_box(const Record& record) {
  static_assert(sizeof(Record) == 32);
  const Int4 keep_xyz{-1, -1, -1, 0};
  Int4 planes[2];
  std::memcpy(planes, &record, sizeof(planes));
  Box box;
  box.lo = reinterpret_cast<Float4>(planes[0] & keep_xyz);
  box.hi = reinterpret_cast<Float4>(planes[1] & keep_xyz);
  return box;
}

template <typename Record>
void store_box(Record& record, const Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    record.lo[axis] = box.lo[axis];
    record.hi[axis] = box.hi[axis];
  }
}

}  // namespace aerostat::bvh
