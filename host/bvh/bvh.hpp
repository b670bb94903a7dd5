#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh_node.h"
#include "core/math.hpp"

/// These functions build bounding volume hierarchies over triangle soups, in the wide layout that
/// the kernels traverse.
namespace aerostat::bvh {

struct Bounds {
  vec3 lo{kInfinity};
  vec3 hi{-kInfinity};
};

struct BuildOptions {
  std::uint32_t max_leaf_triangles = 4;  // at most AERO_BVH_MAX_LEAF
  float traversal_cost = 1.0f;           // cost of one wide node, in the unit of intersection_cost
  float intersection_cost = 0.3f;        // cost of one triangle
};

struct BuildStats {
  std::uint64_t input_triangles = 0;
  std::uint64_t dropped_non_finite = 0;  // triangles with a NaN or infinite vertex
  std::uint64_t dropped_degenerate = 0;  // triangles of zero area
  std::uint64_t nodes = 0;
  std::uint64_t leaves = 0;
  std::uint32_t stack_entries = 0;  // largest number that a traversal can need
  double sah_cost = 0.0;            // expected cost of a ray that hits the root's box
  double seconds = 0.0;
};

/// A tree over `slots` triangles. Leaf slot i holds the caller's triangle order[i], unless
/// `order` was emptied to save memory. Patches of a height grid have no slots.
struct Bvh {
  std::vector<AeroBvhNode> nodes;
  std::vector<std::uint32_t> order;
  std::uint32_t slots = 0;
  Bounds bounds;
  BuildStats stats;
};

/// Builds a tree by the surface area heuristic on all cores. The same input gives the same tree,
/// whatever the number of threads. Non-finite and zero-area triangles are dropped and counted. An
/// empty input gives one node without children. Throws Error{internal} if an index is out of
/// range, and Error{bad_data} if there are more than 2^27 triangles, which the tree could not
/// address.
Bvh build(std::span<const vec3> positions, std::span<const uvec3> triangles,
          const BuildOptions& options = {});

/// Trees under a common root, and the trees of models among the same nodes.
struct JoinedBvh : Bvh {
  std::vector<std::uint32_t> model_roots;  // node at which the tree of each model begins
};

/// Joins trees under a common root without rebuilding them. Triangle indices in `order` of tree k
/// are raised by `first_triangle[k]`. References to nodes and leaves are shifted to the new
/// places. Patches and instances keep their numbers, so that at most one tree may have patches
/// and at most one may have instances. If the `order` of a tree was emptied, the result has none.
/// The trees of `models` are placed beside the others and only instances refer to them. Their
/// slots come after all other slots. Throws Error{internal} if the result would need more stack
/// than the kernels have.
JoinedBvh join(std::span<const Bvh* const> trees, std::span<const std::uint32_t> first_triangle,
               std::span<const Bvh* const> models = {});

}  // namespace aerostat::bvh
