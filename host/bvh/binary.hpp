#pragma once

#include <bit>
#include <memory>

#include "forest.hpp"
#include "primitive.hpp"

namespace aerostat::bvh {

/// The largest number of levels of the binary tree below its root. 3 * 21 levels fold into a
/// chain of 21 wide nodes of eight children, which needs 148 stack entries.
inline constexpr int kMaxDepth = 63;

/// An inner node. A subtree over n primitives has n - 1 nodes in depth-first order. The left
/// child of the node at i is at i + 1, and the right child is at i + left_count. A child over one
/// primitive has no node.
struct BinaryNode {
  float lo[3];
  std::uint32_t left_count;
  float hi[3];
  std::uint32_t plan;
};

/// A subtree: its first node and its range of primitives. A subtree of one primitive has no node.
struct Subtree {
  std::uint32_t node = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

struct BinaryTree {
  std::unique_ptr<BinaryNode[]> nodes;

  Subtree left(const Subtree& s) const { return {s.node + 1, s.first, nodes[s.node].left_count}; }
  Subtree right(const Subtree& s) const {
    const std::uint32_t n = nodes[s.node].left_count;
    return {s.node + n, s.first + n, s.count - n};
  }
};

/// Returns whether a subtree at this depth must be halved so that its leaves do not lie below
/// kMaxDepth. An uneven split could leave a child of nearly as many primitives one level lower.
inline bool must_halve(int depth, std::uint32_t count) {
  return depth + 1 + std::bit_width(count - 1) > kMaxDepth;
}

/// Builds the tree down to single primitives and reorders these to the order of its leaves. Each
/// node carries the plan of its collapse.
BinaryTree build_binary(PrimitiveSet& primitives, const BuildOptions& options);

}  // namespace aerostat::bvh
