#pragma once

#include <cstring>

#include "planes.hpp"

namespace aerostat::bvh {

template <bool kWide>
struct Lanes;
template <>
struct Lanes<false> {
  static constexpr int kCount = 4;
  using Float = Float4;
  using Int = Int4;
};
template <>
struct Lanes<true> {
  static constexpr int kCount = 8;
  using Float = Float8;
  using Int = Int8;
};

/// Up to kMost numbers, and for each of them how many come before it in ascending order.
template <bool kWide, int kMost>
struct Ranks {
  alignas(32) float key[kMost];
  alignas(32) std::int32_t rank[kMost];

  /// Computes the ranks of the first `n` numbers. Each is compared with all, so that there is no
  /// branch to mispredict. Equal numbers keep their order.
  AEROSTAT_INLINE void count(int n) {
    using Float = typename Lanes<kWide>::Float;
    using Int = typename Lanes<kWide>::Int;
    constexpr int kLanes = Lanes<kWide>::kCount;
    static_assert(kMost % kLanes == 0);
    for (int begin = 0; begin < n; begin += kLanes) {
      Float own;
      Int before{}, place;
      std::memcpy(&own, key + begin, sizeof(own));
      for (int lane = 0; lane < kLanes; ++lane) place[lane] = begin + lane;
      for (int i = 0; i < n; ++i) {
        const Float other = Float{} + key[i];
        before -= place > i ? other <= own : other < own;
      }
      std::memcpy(rank + begin, &before, sizeof(before));
    }
  }
};

}  // namespace aerostat::bvh
