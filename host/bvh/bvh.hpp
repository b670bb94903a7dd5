#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh_node.h"
#include "core/math.hpp"

/// Bounding volume hierarchies over triangle soups, in the wide layout that the kernels traverse.
namespace aerostat::bvh {

struct Bounds {
  vec3 lo{kInfinity};
  vec3 hi{-kInfinity};
};

struct BuildOptions {
  std::uint32_t max_leaf_triangles = 4;  // at most AERO_BVH_MAX_LEAF
  float traversal_cost = 1.0f;           // of one wide node, in the unit of intersection_cost
  float intersection_cost = 0.3f;        // of one triangle
};

struct BuildStats {
  std::uint64_t input_triangles = 0;
  std::uint64_t dropped_non_finite = 0;  // a NaN or infinite vertex
  std::uint64_t dropped_degenerate = 0;  // zero area
  std::uint64_t nodes = 0;
  std::uint64_t leaves = 0;
  std::uint32_t stack_entries = 0;  // what a traversal can need at most
  double sah_cost = 0.0;            // expected cost of a ray that hits the root's box
  double seconds = 0.0;
};

/// A tree over `slots` triangles: leaf slot i holds the caller's triangle order[i], where `order`
/// was not given up (emptied). Patches of a height grid have no slots.
struct Bvh {
  std::vector<AeroBvhNode> nodes;
  std::vector<std::uint32_t> order;
  std::uint32_t slots = 0;
  Bounds bounds;
  BuildStats stats;
};

/// Builds a tree by the surface area heuristic on all cores; the same input gives the same tree,
/// whatever the number of threads. Non-finite and zero-area triangles are dropped and counted.
/// An empty input gives one node without children. Throws Error{internal} on an index out of
/// range, Error{bad_data} if the tree cannot be addressed (2^27 triangles).
Bvh build(std::span<const vec3> positions, std::span<const uvec3> triangles,
          const BuildOptions& options = {});

/// Trees under a common root, and models' trees among the same nodes.
struct JoinedBvh : Bvh {
  std::vector<std::uint32_t> model_roots;  // node at which each model's tree begins
};

/// Joins trees under a common root without touching them: triangle indices in `order` of tree k are
/// raised by `first_triangle[k]`, node and leaf references likewise; patches and instances stay
/// what they are, so that one tree at most may have some of either. Where a tree's `order` was
/// given up, the result has none. The trees of `models`, whose slots come behind all others, are
/// placed beside them and referred to by instances alone. Throws Error{internal} if the result
/// would need more stack than the kernels have.
JoinedBvh join(std::span<const Bvh* const> trees, std::span<const std::uint32_t> first_triangle,
               std::span<const Bvh* const> models = {});

}  // namespace aerostat::bvh
