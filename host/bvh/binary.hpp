#pragma once

#include <bit>
#include <memory>

#include "forest.hpp"
#include "primitive.hpp"

namespace aerostat::bvh {

/// Levels of the binary tree below its root, at most: what 3 * 21 levels fold into, 21 wide nodes
/// of eight children, needs 148 stack entries.
inline constexpr int kMaxDepth = 63;

/// An inner node. A subtree over n primitives has n - 1 of them, in depth-first order: the left
/// child of the node at i is at i + 1, the right one at i + left_count; a child over one primitive
/// has no node.
struct BinaryNode {
  float lo[3];
  std::uint32_t left_count;
  float hi[3];
  std::uint32_t plan;
};

/// A subtree: its node (none if it holds one primitive) and its range of primitives.
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

/// Whether a subtree at this depth must be halved to end above kMaxDepth: an uneven split could
/// leave a child of nearly as many primitives one level lower.
inline bool must_halve(int depth, std::uint32_t count) {
  return depth + 1 + std::bit_width(count - 1) > kMaxDepth;
}

/// Builds the tree down to single primitives and reorders these to its leaves' order. Each node
/// carries the plan of its collapse.
BinaryTree build_binary(PrimitiveSet& primitives, const BuildOptions& options);

}  // namespace aerostat::bvh
