#include <chrono>

#include <tbb/parallel_for.h>

#include "binary.hpp"
#include "bvh.hpp"
#include "collapse.hpp"
#include "primitive.hpp"

namespace aerostat::bvh {
namespace {

std::vector<std::uint32_t> order_of(const PrimitiveSet& primitives) {
  std::vector<std::uint32_t> order(primitives.count);
  tbb::parallel_for(std::size_t{0}, order.size(),
                    [&](std::size_t i) { order[i] = primitives.items[i].triangle; });
  return order;
}

}  // namespace

Bvh build(std::span<const vec3> positions, std::span<const uvec3> triangles,
          const BuildOptions& options) {
  check_input(triangles.size(), options);
  const auto start = std::chrono::steady_clock::now();
  PrimitiveSet primitives = collect_primitives(positions, triangles);
  Bvh bvh;
  bvh.bounds = to_bounds(primitives.bounds);
  {
    const BinaryTree tree = build_binary(primitives, options);
    bvh.nodes = collapse(tree, primitives, options);
  }
  bvh.order = order_of(primitives);
  bvh.slots = primitives.count;
  bvh.stats.input_triangles = triangles.size();
  bvh.stats.dropped_non_finite = primitives.non_finite;
  bvh.stats.dropped_degenerate = primitives.degenerate;
  measure(bvh.nodes, bvh.bounds, options, bvh.stats);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  bvh.stats.seconds = elapsed.count();
  return bvh;
}

}  // namespace aerostat::bvh
