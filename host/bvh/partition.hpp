#pragma once

#include <algorithm>
#include <cstring>

#include "bins.hpp"

namespace aerostat::bvh {

AEROSTAT_INLINE void exchange(Primitive& a, Primitive& b) {
  Int8 from_a, from_b;
  std::memcpy(&from_a, &a, sizeof(a));
  std::memcpy(&from_b, &b, sizeof(b));
  std::memcpy(&a, &from_b, sizeof(a));
  std::memcpy(&b, &from_a, sizeof(b));
}

/// The bounds of the centroids on both sides of a plane. A primitive is taken into both bounds,
/// but as an empty box into the bounds of the other side. There is no branch, because the
/// processor could not predict which side comes next.
template <bool kWide>
struct SideCentroids {
  Float8 sides[2] = {no_planes(), no_planes()};

  AEROSTAT_INLINE void take_in(const Primitive& primitive, bool goes_left) {
    const Int8 negate{0, 0, 0, 0, kSignBit, kSignBit, kSignBit, kSignBit};
    const Float4 half = half_centre(load_planes(primitive));
    const Float8 centre =
        reinterpret_cast<Float8>(reinterpret_cast<Int8>(joined(half, half)) ^ negate);
    const Int8 is_left = Int8{} - static_cast<std::int32_t>(goes_left);
    sides[0] = united<kWide>(sides[0], is_left ? centre : no_planes());
    sides[1] = united<kWide>(sides[1], is_left ? no_planes() : centre);
  }
};

/// Partitions in place, gathers the bounds of the centroids of both sides, and returns the number
/// of primitives left of the plane. No branch depends on the side of a primitive. Each primitive
/// is exchanged with the first one that is known to lie on the right, or with itself.
template <bool kWide>
AEROSTAT_INLINE std::size_t partition(Primitive* first, std::size_t count, const BinMap& map,
                                      const Plane& plane, Box (&centroids)[2]) {
  const int axis = plane.axis;
  const float origin = map.origin[axis], scale = map.scale[axis];
  const auto bin = static_cast<float>(plane.bin);
  SideCentroids<kWide> seen;
  Primitive* left = first;
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    Primitive* const block = first + begin;
    const std::size_t n = std::min(count - begin, kBlock);
    bool goes_left[kBlock];
    for (std::size_t i = 0; i < n; ++i) {
      // The scaled place is not below 0, so that comparing it is the same as comparing the bin
      // that it is cut to.
      const float place = block[i].lo[axis] * 0.25f + block[i].hi[axis] * 0.25f;
      goes_left[i] = (place - origin) * scale < bin;
    }
    for (std::size_t i = 0; i < n; ++i) {
      seen.take_in(block[i], goes_left[i]);
      exchange(block[i], *left);
      left += goes_left[i] ? 1 : 0;
    }
  }
  for (int side = 0; side < 2; ++side) centroids[side] = to_box(seen.sides[side]);
  return static_cast<std::size_t>(left - first);
}

}  // namespace aerostat::bvh
