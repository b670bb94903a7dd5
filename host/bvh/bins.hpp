#pragma once

#include <algorithm>
#include <cmath>

#include "planes.hpp"
#include "primitive.hpp"

/// These functions search for the best plane by the surface area heuristic over bins (Wald, "On
/// fast construction of SAH-based bounding volume hierarchies", 2007). Those on vectors are
/// inlined into the loops of loops.cpp.
namespace aerostat::bvh {

inline constexpr int kMostBins = 32;

/// The number of primitives whose bins are computed before any of them is used. Loads and stores
/// whose places are known early need not wait for each other.
inline constexpr std::size_t kBlock = 32;

/// The contents of the bins of one number, by axis. The size is a power of two, so that a bin is
/// found by a shift.
struct alignas(128) Bin {
  Float8 box[3];
  Int4 held;
};

struct Bins {
  Bins() = default;  // leaves the contents unknown
  explicit Bins(int bins) : count(bins) {
    for (int i = 0; i < bins; ++i) {
      for (Float8& planes : bin[i].box) planes = no_planes();
      bin[i].held = Int4{};
    }
  }

  int count;
  Bin bin[kMostBins];
};

/// Maps centroids to bins. An axis whose extent cannot be divided in floats has scale 0, which
/// puts all centroids into one bin.
struct BinMap {
  Float4 origin;
  Float4 scale = broadcast(0.0f);
  int bins;

  BinMap(const Box& centroids, int bin_count) : origin(centroids.lo), bins(bin_count) {
    for (int axis = 0; axis < 3; ++axis) {
      const float extent = centroids.hi[axis] - centroids.lo[axis];
      const float s = static_cast<float>(bins) * 0.99999f / extent;
      if (extent > 0.0f && std::isfinite(s)) scale[axis] = s;
    }
    origin[3] = 0.0f;
  }
};

/// A plane between two bins of an axis.
struct Plane {
  int axis = -1;  // -1: no plane parts the primitives, or costs exceed the range of floats
  int bin = 0;    // first bin of the right side
};

template <bool kWide>
AEROSTAT_INLINE void fill_bins(Bins& bins, const Primitive* first, std::size_t count,
                               const BinMap& map) {
  const Float4 origin = map.origin, scale = map.scale;
  Int4 number[kBlock];
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const Primitive* const block = first + begin;
    const std::size_t n = std::min(count - begin, kBlock);
    for (std::size_t i = 0; i < n; ++i) {
      const Float4 centre = half_centre(load_planes(block[i]));
      number[i] = __builtin_convertvector((centre - origin) * scale, Int4);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Float8 planes = load_planes(block[i]);
      for (int axis = 0; axis < 3; ++axis) {
        Bin& bin = bins.bin[static_cast<std::uint32_t>(number[i][axis])];
        bin.box[axis] = united<kWide>(bin.box[axis], planes);
        ++bin.held[axis];
      }
    }
  }
}

/// The cost of one side of the planes before bin `i`, by axis. The cost of an empty side is NaN,
/// because its area is infinite and its count is 0. NaN is never less than another cost.
template <bool kWide>
struct Side {
  Float8 box[3] = {no_planes(), no_planes(), no_planes()};
  Int4 held{};

  AEROSTAT_INLINE void take_in(const Bin& bin) {
    for (int axis = 0; axis < 3; ++axis) box[axis] = united<kWide>(box[axis], bin.box[axis]);
    held += bin.held;
  }
  AEROSTAT_INLINE Float4 cost() const {
    return half_areas(box[0], box[1], box[2], box[2]) * __builtin_convertvector(held, Float4);
  }
};

/// Returns the plane of least cost. Among planes of equal cost, it is the first by axis and then
/// by bin.
template <bool kWide>
AEROSTAT_INLINE Plane search_plane(const Bins& bins) {
  Float4 right_cost[kMostBins];
  Side<kWide> right, left;
  for (int i = bins.count - 1; i > 0; --i) {
    right.take_in(bins.bin[i]);
    right_cost[i] = right.cost();
  }
  Float4 least = broadcast(kInfinity);
  Int4 best{};
  for (int i = 1; i < bins.count; ++i) {
    left.take_in(bins.bin[i - 1]);
    const Float4 cost = left.cost() + right_cost[i];
    const Int4 better = cost < least;
    least = better ? cost : least;
    best = better ? Int4{i, i, i, i} : best;
  }
  Plane plane;
  float least_cost = kInfinity;
  for (int axis = 0; axis < 3; ++axis) {
    if (least[axis] < least_cost) {
      least_cost = least[axis];
      plane = {axis, best[axis]};
    }
  }
  return plane;
}

/// Computes the boxes of both sides of a plane.
template <bool kWide>
AEROSTAT_INLINE void bound_sides(const Bins& bins, const Plane& plane, Box (&bounds)[2]) {
  Float8 sides[2] = {no_planes(), no_planes()};
  for (int i = 0; i < bins.count; ++i) {
    Float8& side = sides[i < plane.bin ? 0 : 1];
    side = united<kWide>(side, bins.bin[i].box[plane.axis]);
  }
  for (int side = 0; side < 2; ++side) bounds[side] = to_box(sides[side]);
}

}  // namespace aerostat::bvh
