#pragma once

#include <algorithm>
#include <cstdint>

#include "bvh.hpp"
#include "planes.hpp"

namespace aerostat::bvh {

inline constexpr int kWidth = AERO_BVH_WIDTH;

/// How a binary subtree is best covered by at most i + 1 wide subtrees (inner nodes or leaves), in
/// lanes i = 0 .. kWidth - 2: the tables of Ylitie, Karras and Laine, "Efficient incoherent ray
/// traversal on GPUs through compressed wide BVHs" (2017), section 3.1, with the stack that each
/// choice needs. The last lane says nothing.
struct Forest {
  Float8 cost;  // surface area times cost; more slots are never dearer
  Int8 stack;   // most stack entries that one of the subtrees needs
  Int8 used;    // subtrees in fact used
};
static_assert(kWidth == 8, "a lane for each number of slots");

/// The choices that a Forest stands for, kept in 32 bits per binary node.
class Plan {
 public:
  Plan() = default;
  explicit Plan(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits() const { return bits_; }

  /// How many of `slots` (2 .. kWidth) the left child gets; 0: the subtree is best taken as one.
  int left_slots(int slots) const { return static_cast<int>(bits_ >> (3 * (slots - 2))) & 7; }
  /// Whether the subtree, given one slot, is a leaf rather than a wide node.
  bool is_leaf() const { return ((bits_ >> 21) & 1u) != 0; }
  /// The stack entries that the subtree needs as a wide node.
  int stack() const { return static_cast<int>(bits_ >> 22); }

  void set_leaf() { bits_ |= 1u << 21; }
  void set_stack(int entries) { bits_ |= static_cast<std::uint32_t>(entries) << 22; }

 private:
  std::uint32_t bits_ = 0;
};

/// Stack entries of a node that pushes all its children and descends into the worst one.
constexpr int stack_of_node(int children, int deepest_child) {
  return children - 1 + (deepest_child > 1 ? deepest_child : 1);
}

/// The forest of a single triangle.
AEROSTAT_INLINE Forest single_forest(float half_area, const BuildOptions& options) {
  return {Float8{} + half_area * options.intersection_cost, Int8{}, Int8{} + 1};
}

/// The best ways to give so many slots as a lane says to two children: by cost, of equal ones the
/// one that gives the left child the fewest.
struct Shares {
  // Where no cost is a number, halves of the slots, and no less stack than they may need.
  Float8 cost = Float8{} + kInfinity;
  Int8 left{0, 1, 1, 2, 2, 3, 3, 4};
  Int8 stack;
  Int8 used{1, 2, 3, 4, 5, 6, 7, 8};

  AEROSTAT_INLINE Shares(const Forest& l, const Forest& r) {
    const Int8 deeper = l.stack > r.stack ? l.stack : r.stack;
    stack = __builtin_shufflevector(deeper, deeper, 0, 0, 0, 0, 0, 0, 0, 0);
  }

  /// Tries to give the left child kLeft slots.
  template <int kLeft>
  AEROSTAT_INLINE void consider(const Forest& l, const Forest& r) {
    constexpr int kLane = kLeft - 1;
    const Float8 none = Float8{} + kInfinity;
    const Float8 shared = l.cost[kLane] + moved<kLeft>(none, r.cost);
    const Int8 better = shared < cost;
    cost = better ? shared : cost;
    left = better ? Int8{} + kLeft : left;
    used = better ? l.used[kLane] + moved<kLeft>(Int8{}, r.used) : used;
    const Int8 right_stack = moved<kLeft>(Int8{}, r.stack), left_stack = Int8{} + l.stack[kLane];
    stack = better ? (left_stack > right_stack ? left_stack : right_stack) : stack;
  }

 private:
  // Moves lanes up by kBy and fills up from `fill`.
  template <int kBy, typename Vector>
  static AEROSTAT_INLINE Vector moved(const Vector& fill, const Vector& v) {
    return __builtin_shufflevector(fill, v, 8 - kBy, 9 - kBy, 10 - kBy, 11 - kBy, 12 - kBy,
                                   13 - kBy, 14 - kBy, 15 - kBy);
  }
};

/// The forest of a binary node over `count` triangles, and the choices that lead to it.
AEROSTAT_INLINE Forest combine(const Forest& left, const Forest& right, float half_area,
                               std::uint32_t count, const BuildOptions& options, Plan& plan) {
  Shares shares(left, right);
  shares.consider<1>(left, right);
  shares.consider<2>(left, right);
  shares.consider<3>(left, right);
  shares.consider<4>(left, right);
  shares.consider<5>(left, right);
  shares.consider<6>(left, right);
  shares.consider<7>(left, right);
  const int last = kWidth - 1;
  const int stack = stack_of_node(shares.used[last], shares.stack[last]);
  const float node_cost = shares.cost[last] + half_area * options.traversal_cost;
  const float leaf_cost = half_area * static_cast<float>(count) * options.intersection_cost;
  const bool is_leaf = count <= options.max_leaf_triangles && !(node_cost < leaf_cost);
  const Float8 root_cost = Float8{} + (is_leaf ? leaf_cost : node_cost);
  const Int8 split = shares.cost < root_cost;
  Int8 choices = shares.left & split;
  choices[last] = shares.left[last];
  choices = choices << Int8{0, 0, 3, 6, 9, 12, 15, 18};
  std::uint32_t bits = 0;
  for (int lane = 1; lane < kWidth; ++lane) bits |= static_cast<std::uint32_t>(choices[lane]);
  plan = Plan(bits);
  plan.set_stack(stack);
  if (is_leaf) plan.set_leaf();
  return {split ? shares.cost : root_cost, split ? shares.stack : Int8{} + (is_leaf ? 0 : stack),
          split ? shares.used : Int8{} + 1};
}

}  // namespace aerostat::bvh
