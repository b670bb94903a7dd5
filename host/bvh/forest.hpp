#pragma once

#include <cstdint>

#include "bvh.hpp"

namespace aerostat::bvh {

inline constexpr int kWidth = AERO_BVH_WIDTH;

/// How a binary subtree is best covered by at most i wide subtrees (inner nodes or leaves), for
/// i = 1 .. kWidth - 1: the tables of Ylitie, Karras and Laine, "Efficient incoherent ray traversal
/// on GPUs through compressed wide BVHs" (2017), section 3.1, with the stack that each choice
/// needs.
struct Forest {
  float cost[kWidth];           // [i], surface area times cost
  std::uint16_t stack[kWidth];  // most stack entries that one of the subtrees needs
  std::uint8_t used[kWidth];    // subtrees in fact used
};

/// The choices that a Forest stands for, kept in 32 bits per binary node.
class Plan {
 public:
  Plan() = default;
  explicit Plan(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits() const { return bits_; }

  /// How many of `slots` (2 .. kWidth) the left child gets; 0: one slot less is as good.
  int left_slots(int slots) const { return static_cast<int>(bits_ >> (3 * (slots - 2))) & 7; }
  /// Whether the subtree, given one slot, is a leaf rather than a wide node.
  bool is_leaf() const { return ((bits_ >> 21) & 1u) != 0; }
  /// The stack entries that the subtree needs as a wide node.
  int stack() const { return static_cast<int>(bits_ >> 22); }

  void set_left_slots(int slots, int k) {
    bits_ |= static_cast<std::uint32_t>(k) << (3 * (slots - 2));
  }
  void set_leaf() { bits_ |= 1u << 21; }
  void set_stack(int entries) { bits_ |= static_cast<std::uint32_t>(entries) << 22; }

 private:
  std::uint32_t bits_ = 0;
};

/// The forest of a single triangle.
Forest single_forest(float half_area, const BuildOptions& options);

/// The forest of a binary node over `count` triangles, and the choices that lead to it.
Forest combine(const Forest& left, const Forest& right, float half_area, std::uint32_t count,
               const BuildOptions& options, Plan& plan);

/// Stack entries of a node that pushes all its children and descends into the worst one.
constexpr int stack_of_node(int children, int deepest_child) {
  return children - 1 + (deepest_child > 1 ? deepest_child : 1);
}

}  // namespace aerostat::bvh
