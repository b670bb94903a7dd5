#pragma once

#include <span>

#include "binary.hpp"

namespace aerostat::bvh {

/// Ranges up to this size are split by testing every position instead of a few bins.
inline constexpr std::uint32_t kSweepCount = 32;

/// Builds the subtree over at most kSweepCount primitives by exact surface area heuristic, writes
/// its nodes from `nodes` on and reorders the primitives. `depth` is that of its root.
Forest sweep(std::span<Primitive> range, BinaryNode* nodes, int depth, const BuildOptions& options);

}  // namespace aerostat::bvh
