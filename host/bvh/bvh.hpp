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

/// A tree that is to be joined with others.
struct Part {
  const Bvh* tree = nullptr;
  bool is_model = false;             // no child of the common root: instances alone refer to it
  std::uint32_t first_triangle = 0;  // is added to the triangle indices in its `order`
  std::uint32_t first_instance = 0;  // is added to the instance numbers in its leaves
};

/// Joins trees under a common root. The slots of the parts follow each other in the parts' order;
/// node and leaf references are raised accordingly. Patches stay what they are, so that one tree at
/// most may have some. Where a part's `order` was given up, the result has none. Throws
/// Error{internal} if the result would need more stack than the kernels have, Error{bad_data} if it
/// cannot be addressed (2^27 triangles).
JoinedBvh join(std::span<const Part> parts);

}  // namespace aerostat::bvh
