#pragma once

#include <cstdint>

#include "planes.hpp"

/// These functions find the cheapest way to part three or four boxes among all ways.
namespace aerostat::bvh {

/// An order of up to four boxes and the number of boxes, from the first on, that make the left
/// side.
struct Parting {
  std::uint8_t order[4];
  std::uint8_t left_count;
};

inline constexpr Parting kPartingsOfThree[] = {
    {{0, 1, 2, 3}, 1}, {{1, 0, 2, 3}, 1}, {{2, 0, 1, 3}, 1}};
inline constexpr Parting kPartingsOfFour[] = {
    {{0, 1, 2, 3}, 1}, {{1, 0, 2, 3}, 1}, {{2, 0, 1, 3}, 1}, {{3, 0, 1, 2}, 1},
    {{0, 1, 2, 3}, 2}, {{0, 2, 1, 3}, 2}, {{0, 3, 1, 2}, 2}};

/// Returns costs, which must not be negative, as integers whose last three bits hold the numbers
/// of the lanes, from `first` on. The integers are in the order of the costs, apart from
/// differences in those three bits.
AEROSTAT_INLINE Int4 numbered(Float4 cost, std::int32_t first) {
  return (reinterpret_cast<Int4>(cost) & ~7) | (Int4{0, 1, 2, 3} + first);
}
AEROSTAT_INLINE int least_number(Int4 a) {
  Int4 b = __builtin_shufflevector(a, a, 2, 3, 0, 1);
  a = a < b ? a : b;
  b = __builtin_shufflevector(a, a, 1, 0, 3, 2);
  a = a < b ? a : b;
  return a[0] & 7;
}

template <bool kWide>
AEROSTAT_INLINE const Parting& part_three(const Float8& a, const Float8& b, const Float8& c) {
  const Float4 one = half_areas(a, b, c, c);
  const Float4 two = half_areas(united<kWide>(b, c), united<kWide>(a, c), united<kWide>(a, b),
                                united<kWide>(a, b));
  return kPartingsOfThree[least_number(numbered(one + 2.0f * two, 0))];
}

template <bool kWide>
AEROSTAT_INLINE const Parting& part_four(const Float8& a, const Float8& b, const Float8& c,
                                         const Float8& d) {
  const Float8 ab = united<kWide>(a, b), cd = united<kWide>(c, d);
  const Float8 ac = united<kWide>(a, c), bd = united<kWide>(b, d);
  const Float8 ad = united<kWide>(a, d), bc = united<kWide>(b, c);
  const Float4 one = half_areas(a, b, c, d);
  const Float4 three = half_areas(united<kWide>(b, cd), united<kWide>(a, cd), united<kWide>(ab, d),
                                  united<kWide>(ab, c));
  const Float4 two = half_areas(ab, ac, ad, ad) + half_areas(cd, bd, bc, bc);
  const Int4 uneven = numbered(one + 3.0f * three, 0);
  const Int4 even = numbered(2.0f * two, 4);
  return kPartingsOfFour[least_number(uneven < even ? uneven : even)];
}

}  // namespace aerostat::bvh
