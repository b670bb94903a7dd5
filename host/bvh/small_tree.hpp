#pragma once

#include <cstring>

#include "binary.hpp"
#include "bins.hpp"
#include "few.hpp"
#include "ranks.hpp"

namespace aerostat::bvh {

/// The largest range that becomes a tree by testing every position along each axis instead of a
/// few bins, and every way to part three or four primitives.
inline constexpr int kSmallCount = 16;

/// A subtree over a few primitives. They are parted from the root down, and costs are computed
/// from the leaves up.
template <bool kWide>
class SmallTree {
 public:
  AEROSTAT_INLINE SmallTree(const Primitive* first, int count) : count_(count) {
    for (int i = 0; i < count; ++i) {
      planes_[i] = load_planes(first[i]);
      order_[i] = static_cast<std::uint8_t>(i);
    }
  }

  /// Parts the primitives down to single ones. `depth` is the depth of the root.
  AEROSTAT_INLINE void part(int depth) {
    Segment open[kSmallCount] = {{0, count_, 0, depth}};
    for (int n = 1; n > 0;) {
      const Segment s = open[--n];
      const int left = part(s);
      nodes_[s.node] = {s.begin, s.count, left};
      const int right = s.count - left;
      if (right > 1) open[n++] = {s.begin + left, right, s.node + left, s.depth + 1};
      if (left > 1) open[n++] = {s.begin, left, s.node + 1, s.depth + 1};
    }
  }

  /// Computes the costs and writes the nodes to `out` and the forest of the root to `forest`.
  AEROSTAT_INLINE void cost(const BuildOptions& options, BinaryNode* out, Forest& forest) const {
    Forest forests[kSmallCount - 1];
    Float8 planes[kSmallCount - 1];
    for (int i = count_ - 2; i >= 0; --i) {
      const Node& node = nodes_[i];
      const int right_count = node.count - node.left;
      const Float8 left = node.left > 1 ? planes[i + 1] : at(node.begin);
      const Float8 right = right_count > 1 ? planes[i + node.left] : at(node.begin + node.left);
      const Forest l = node.left > 1 ? forests[i + 1] : single_forest(half_area(left), options);
      const Forest r =
          right_count > 1 ? forests[i + node.left] : single_forest(half_area(right), options);
      planes[i] = united<kWide>(left, right);
      Plan plan;
      forests[i] = combine(l, r, half_area(planes[i]), static_cast<std::uint32_t>(node.count),
                           options, plan);
      store_box(out[i], to_box(planes[i]));
      out[i].left_count = static_cast<std::uint32_t>(node.left);
      out[i].plan = plan.bits();
    }
    forest = forests[0];
  }

  /// Reorders the primitives to the order of the tree's leaves.
  AEROSTAT_INLINE void reorder(Primitive* first) const {
    Primitive copy[kSmallCount];
    std::memcpy(copy, first, static_cast<std::size_t>(count_) * sizeof(Primitive));
    for (int i = 0; i < count_; ++i) first[i] = copy[order_[i]];
  }

 private:
  /// A range of the primitives and the node that will part it.
  struct Segment {
    int begin, count, node, depth;
  };

  struct Node {
    int begin, count, left;
  };

  AEROSTAT_INLINE const Float8& at(int i) const { return planes_[order_[i]]; }

  // Reorders a segment and returns how many primitives come to the left.
  AEROSTAT_INLINE int part(const Segment& s) {
    const int i = s.begin;
    if (s.count == 2) return 1;
    if (s.count == 3) return reordered(s, part_three<kWide>(at(i), at(i + 1), at(i + 2)));
    const bool halve = must_halve(s.depth, static_cast<std::uint32_t>(s.count));
    if (s.count > 4 || halve) return sweep(s, halve);
    return reordered(s, part_four<kWide>(at(i), at(i + 1), at(i + 2), at(i + 3)));
  }

  AEROSTAT_INLINE int reordered(const Segment& s, const Parting& parting) {
    std::uint8_t copy[4];
    for (int i = 0; i < 4; ++i) copy[i] = order_[s.begin + i];
    for (int i = 0; i < s.count; ++i) order_[s.begin + i] = copy[parting.order[i]];
    return parting.left_count;
  }

  // Parts a segment by a search in which every primitive is a bin of its own along each axis.
  AEROSTAT_INLINE int sweep(const Segment& s, bool halve) {
    Ranks<kWide, kSmallCount> ranks[3];
    Bins bins;
    bins.count = s.count;
    for (int i = 0; i < s.count; ++i) {
      const Float4 centre = half_centre(at(s.begin + i));
      for (int axis = 0; axis < 3; ++axis) ranks[axis].key[i] = centre[axis];
      bins.bin[i].held = Int4{1, 1, 1, 1};
    }
    for (auto& axis : ranks) axis.count(s.count);
    for (int i = 0; i < s.count; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        bins.bin[ranks[axis].rank[i]].box[axis] = at(s.begin + i);
    }
    Plane plane;
    if (!halve) plane = search_plane<kWide>(bins);
    if (plane.axis < 0) plane = {0, s.count / 2};
    std::uint8_t copy[kSmallCount];
    for (int i = 0; i < s.count; ++i) copy[i] = order_[s.begin + i];
    for (int i = 0; i < s.count; ++i) order_[s.begin + ranks[plane.axis].rank[i]] = copy[i];
    return plane.bin;
  }

  int count_;
  Float8 planes_[kSmallCount];
  std::uint8_t order_[kSmallCount + 2];  // longer, because parting three copies four
  Node nodes_[kSmallCount - 1];
};

}  // namespace aerostat::bvh
