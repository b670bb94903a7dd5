#pragma once

#include <vector>

#include "binary.hpp"

namespace aerostat::bvh {

/// The stack entries that a built tree may need. The remaining entries of the kernels are for the
/// node that joins trees.
inline constexpr int kStackBudget = AERO_BVH_STACK - AERO_BVH_WIDTH;

/// Folds the binary tree into wide nodes by the plans in its nodes. Parents come before children.
/// A subtree whose plan needs more than `stack_budget` entries is folded three binary levels at a
/// time, which needs at most 148 entries.
std::vector<AeroBvhNode> collapse(const BinaryTree& tree, const PrimitiveSet& primitives,
                                  const BuildOptions& options, int stack_budget = kStackBudget);

/// Returns a node without children.
AeroBvhNode empty_node();

void set_child(AeroBvhNode& node, int slot, const Bounds& bounds, std::uint32_t reference);

/// Computes nodes, leaves, stack_entries and sah_cost of `stats` from the nodes. Patches are not
/// counted. Parents must come before children.
void measure(const std::vector<AeroBvhNode>& nodes, const Bounds& bounds,
             const BuildOptions& options, BuildStats& stats);

}  // namespace aerostat::bvh
