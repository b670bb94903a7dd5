#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "bvh/bvh.hpp"
#include "bvh/collapse.hpp"
#include "support/bvh_meshes.hpp"

/// Checks finished trees against their definition.
namespace aerostat::test {

inline bool contains(const bvh::Bounds& outer, const vec3& p) {
  return glm::all(glm::lessThanEqual(outer.lo, p)) && glm::all(glm::lessThanEqual(p, outer.hi));
}

inline bvh::Bounds child_bounds(const AeroBvhNode& node, int i) {
  return {{node.lo[0][i], node.lo[1][i], node.lo[2][i]},
          {node.hi[0][i], node.hi[1][i], node.hi[2][i]}};
}

// Traverses a tree by nothing but the definitions in bvh_node.h, and collects the values that its
// statistics claim.
class Inspector {
 public:
  Inspector(const bvh::Bvh& tree, const Soup& soup, std::uint32_t max_leaf)
      : tree_(tree), soup_(soup), max_leaf_(max_leaf), seen_(tree.order.size()) {
    stack = visit(0, tree.bounds);
  }

  bool every_slot_once() const {
    return std::all_of(seen_.begin(), seen_.end(), [](int n) { return n == 1; });
  }

  std::uint32_t nodes = 0, leaves = 0, stack = 0;
  /// Tells whether all bounds contain their content, all leaves have at most their largest size,
  /// and all references lie within the tree.
  bool sound = true;

 private:
  std::uint32_t visit(std::uint32_t index, const bvh::Bounds& bounds) {
    ++nodes;
    std::uint32_t children = 0, deepest = 1;
    const AeroBvhNode& node = tree_.nodes.at(index);
    for (int i = 0; i < AERO_BVH_WIDTH; ++i) {
      const bvh::Bounds box = child_bounds(node, i);
      if (node.child[i] == AERO_BVH_EMPTY) {
        sound &= box.lo == vec3(kInfinity) && box.hi == vec3(-kInfinity);
        continue;
      }
      ++children;
      sound &= contains(bounds, box.lo) && contains(bounds, box.hi);
      if ((node.child[i] & AERO_BVH_LEAF) != 0) {
        visit_leaf(node.child[i], box);
      } else {
        deepest = std::max(deepest, visit(node.child[i], box));
      }
    }
    return children == 0 ? 1 : children - 1 + deepest;
  }

  void visit_leaf(std::uint32_t reference, const bvh::Bounds& box) {
    ++leaves;
    const std::uint32_t first = reference & AERO_BVH_FIRST_MASK;
    const std::uint32_t count = ((reference >> AERO_BVH_COUNT_SHIFT) & AERO_BVH_COUNT_MASK) + 1;
    sound &= count <= max_leaf_;
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      ++seen_.at(slot);
      const uvec3 t = soup_.triangles.at(tree_.order.at(slot));
      for (int k = 0; k < 3; ++k) sound &= contains(box, soup_.positions[t[k]]);
    }
  }

  const bvh::Bvh& tree_;
  const Soup& soup_;
  std::uint32_t max_leaf_;
  std::vector<int> seen_;
};

inline void expect_valid(const bvh::Bvh& tree, const Soup& soup, std::uint32_t max_leaf) {
  const Inspector seen(tree, soup, max_leaf);
  EXPECT_TRUE(seen.sound);
  EXPECT_TRUE(seen.every_slot_once());
  std::vector<std::uint32_t> order = tree.order;
  std::sort(order.begin(), order.end());
  EXPECT_EQ(std::adjacent_find(order.begin(), order.end()), order.end()) << "a triangle twice";
  const bvh::BuildStats& stats = tree.stats;
  EXPECT_EQ(stats.input_triangles - stats.dropped_non_finite - stats.dropped_degenerate,
            tree.order.size());
  EXPECT_EQ(stats.nodes, seen.nodes);
  EXPECT_EQ(stats.nodes, tree.nodes.size());
  EXPECT_EQ(stats.leaves, seen.leaves);
  EXPECT_EQ(stats.stack_entries, seen.stack);
  EXPECT_LE(stats.stack_entries, static_cast<std::uint32_t>(bvh::kStackBudget));
}

inline bool same_bytes(const bvh::Bvh& a, const bvh::Bvh& b) {
  return a.order == b.order && a.nodes.size() == b.nodes.size() &&
         std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(AeroBvhNode)) == 0;
}

}  // namespace aerostat::test
