#include <chrono>
#include <string>

#include <tbb/parallel_for.h>

#include "binary.hpp"
#include "bvh.hpp"
#include "collapse.hpp"
#include "core/error.hpp"
#include "primitive.hpp"

namespace aerostat::bvh {
namespace {

constexpr std::size_t kMaxTriangles = std::size_t{AERO_BVH_FIRST_MASK} + 1;

void check(std::size_t triangles, const BuildOptions& options) {
  if (options.max_leaf_triangles < 1 || options.max_leaf_triangles > AERO_BVH_MAX_LEAF)
    throw Error(ErrorKind::internal, "building a BVH: max_leaf_triangles is " +
                                         std::to_string(options.max_leaf_triangles) +
                                         ", expected 1 to " + std::to_string(AERO_BVH_MAX_LEAF));
  if (triangles > kMaxTriangles)
    throw Error(ErrorKind::bad_data, "building a BVH: " + std::to_string(triangles) +
                                         " triangles, expected at most " +
                                         std::to_string(kMaxTriangles));
}

std::vector<std::uint32_t> order_of(const PrimitiveSet& primitives) {
  std::vector<std::uint32_t> order(primitives.count);
  tbb::parallel_for(std::size_t{0}, order.size(),
                    [&](std::size_t i) { order[i] = primitives.items[i].triangle; });
  return order;
}

Bounds to_bounds(const Box& box) {
  return {{box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]}};
}

}  // namespace

Bvh build(std::span<const vec3> positions, std::span<const uvec3> triangles,
          const BuildOptions& options) {
  check(triangles.size(), options);
  const auto start = std::chrono::steady_clock::now();
  PrimitiveSet primitives = collect_primitives(positions, triangles);
  Bvh bvh;
  bvh.bounds = to_bounds(primitives.bounds);
  {
    const BinaryTree tree = build_binary(primitives, options);
    bvh.nodes = collapse(tree, primitives, options);
  }
  bvh.order = order_of(primitives);
  bvh.stats.input_triangles = triangles.size();
  bvh.stats.dropped_non_finite = primitives.non_finite;
  bvh.stats.dropped_degenerate = primitives.degenerate;
  measure(bvh.nodes, bvh.bounds, options, bvh.stats);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  bvh.stats.seconds = elapsed.count();
  return bvh;
}

}  // namespace aerostat::bvh
