#pragma once

#include <algorithm>
#include <cstdint>

#include "bvh.hpp"
#include "planes.hpp"

namespace aerostat::bvh {

inline constexpr int kWidth = AERO_BVH_WIDTH;

/// The best ways to cover a binary subtree with at most i + 1 wide subtrees (inner nodes or
/// leaves), in lanes i = 0 .. kWidth - 2. They are the tables of Ylitie, Karras and Laine,
/// "Efficient incoherent ray traversal on GPUs through compressed wide BVHs" (2017), section 3.1,
/// with the stack that each way needs. The last lane is not used.
struct Forest {
  Float8 cost;  // surface area times cost; more slots never cost more
  Int8 stack;   // most stack entries that one of the subtrees needs
  Int8 used;    // number of subtrees that are used
};
static_assert(kWidth == 8, "a lane for each number of slots");

/// The choices that lead to a Forest, packed in 32 bits for each binary node.
class Plan {
 public:
  Plan() = default;
  explicit Plan(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits() const { return bits_; }

  /// Returns how many of `slots` (2 .. kWidth) slots the left child gets. Returns 0 if the
  /// subtree is best taken as one.
  int left_slots(int slots) const { return static_cast<int>(bits_ >> (3 * (slots - 2))) & 7; }
  /// Returns whether the subtree, given one slot, is a leaf and not a wide node.
  bool is_leaf() const { return ((bits_ >> 21) & 1u) != 0; }
  /// Returns the stack entries that the subtree needs as a wide node.
  int stack() const { return static_cast<int>(bits_ >> 22); }

  void set_leaf() { bits_ |= 1u << 21; }
  void set_stack(int entries) { bits_ |= static_cast<std::uint32_t>(entries) << 22; }

 private:
  std::uint32_t bits_ = 0;
};

/// Returns the stack entries of a node that pushes all its children and descends into the worst
/// one.
constexpr int stack_of_node(int children, int deepest_child) {
  return children - 1 + (deepest_child > 1 ? deepest_child : 1);
}

/// Returns the forest of a single triangle.
AEROSTAT_INLINE Forest single_forest(float half_area, const BuildOptions& options) {
  return {Float8{} + half_area * options.intersection_cost, Int8{}, Int8{} + 1};
}

/// The best ways to divide slots between two children. Lane i holds the least cost for i + 1
/// slots. Among ways of equal cost, the one that gives the left child the fewest slots is best.
struct Shares {
  // If no cost is finite, each child gets half of the slots, and the stack is at least what the
  // children may need.
  Float8 cost = Float8{} + kInfinity;
  Int8 left{0, 1, 1, 2, 2, 3, 3, 4};
  Int8 stack;
  Int8 used{1, 2, 3, 4, 5, 6, 7, 8};

  AEROSTAT_INLINE Shares(const Forest& l, const Forest& r) {
    const Int8 deeper = l.stack > r.stack ? l.stack : r.stack;
    stack = __builtin_shufflevector(deeper, deeper, 0, 0, 0, 0, 0, 0, 0, 0);
  }

  /// Considers the ways that give the left child kLeft slots.
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
  // Moves lanes up by kBy and fills the first lanes from `fill`.
  template <int kBy, typename Vector>
  static AEROSTAT_INLINE Vector moved(const Vector& fill, const Vector& v) {
    return __builtin_shufflevector(fill, v, 8 - kBy, 9 - kBy, 10 - kBy, 11 - kBy, 12 - kBy,
                                   13 - kBy, 14 - kBy, 15 - kBy);
  }
};

/// Returns the forest of a binary node over `count` triangles, and stores the choices that lead
/// to it in `plan`.
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
