#include "instances.hpp"

#include <chrono>
#include <string>

#include "binary.hpp"
#include "collapse.hpp"
#include "core/error.hpp"
#include "primitive.hpp"

namespace aerostat::bvh {
namespace {

/// The cost for a ray to enter the tree of an instance's model, in the unit of
/// BuildOptions::traversal_cost.
constexpr float kInstanceCost = 10.0f;

Box as_box(const Bounds& bounds, std::size_t number) {
  if (!is_finite(bounds.lo) || !is_finite(bounds.hi) ||
      !glm::all(glm::lessThanEqual(bounds.lo, bounds.hi)))
    throw Error(ErrorKind::bad_data,
                "building a BVH: the box of instance " + std::to_string(number) + " is none");
  Box box;
  box.lo = Float4{bounds.lo.x, bounds.lo.y, bounds.lo.z, 0.0f};
  box.hi = Float4{bounds.hi.x, bounds.hi.y, bounds.hi.z, 0.0f};
  return box;
}

PrimitiveSet as_primitives(std::span<const Bounds> bounds) {
  PrimitiveSet set;
  set.items = std::make_unique_for_overwrite<Primitive[]>(bounds.size());
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const Box box = as_box(bounds[i], i);
    Primitive& item = set.items[set.count++];
    store_box(item, box);
    item.triangle = static_cast<std::uint32_t>(i);
    item.unused = 0;
    set.bounds.grow(box);
    set.centroids.grow(box.half_centre());
  }
  return set;
}

}  // namespace

Bvh build_instances(std::span<const Bounds> bounds) {
  const auto start = std::chrono::steady_clock::now();
  BuildOptions options;
  options.max_leaf_triangles = 1;
  options.intersection_cost = kInstanceCost;
  check_input(bounds.size(), options);
  PrimitiveSet primitives = as_primitives(bounds);
  Bvh bvh;
  bvh.bounds = to_bounds(primitives.bounds);
  const BinaryTree tree = build_binary(primitives, options);
  bvh.nodes = collapse(tree, primitives, options);
  measure(bvh.nodes, bvh.bounds, options, bvh.stats);
  for (AeroBvhNode& node : bvh.nodes) {
    for (aero_uint& child : node.child) {
      if (child == AERO_BVH_EMPTY || (child & AERO_BVH_LEAF) == 0) continue;
      const std::uint32_t number = primitives.items[child & AERO_BVH_FIRST_MASK].triangle;
      child =
          AERO_BVH_LEAF | AERO_BVH_PATCH | AERO_PATCH_INSTANCE << AERO_PATCH_SHAPE_SHIFT | number;
    }
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  bvh.stats.seconds = elapsed.count();
  return bvh;
}

}  // namespace aerostat::bvh
