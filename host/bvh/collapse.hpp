#pragma once

#include <vector>

#include "binary.hpp"

namespace aerostat::bvh {

/// What a built tree may need of the kernels' stack; the rest is for the node that joins trees.
inline constexpr int kStackBudget = AERO_BVH_STACK - AERO_BVH_WIDTH;

/// Folds the binary tree into wide nodes, parents before children, by the plans in its nodes; where
/// these would need more than `stack_budget`, three binary levels at a time, which need 148 at
/// most.
std::vector<AeroBvhNode> collapse(const BinaryTree& tree, const PrimitiveSet& primitives,
                                  const BuildOptions& options, int stack_budget = kStackBudget);

/// A node without children.
AeroBvhNode empty_node();

void set_child(AeroBvhNode& node, int slot, const Bounds& bounds, std::uint32_t reference);

/// What follows from the nodes: nodes, leaves, stack_entries and sah_cost of `stats`, without
/// patches. Parents must come before children.
void measure(const std::vector<AeroBvhNode>& nodes, const Bounds& bounds,
             const BuildOptions& options, BuildStats& stats);

}  // namespace aerostat::bvh
