#include "grid.hpp"

#include <chrono>
#include <string>
#include <vector>

#include <tbb/parallel_for.h>

#include "binary.hpp"
#include "collapse.hpp"
#include "core/error.hpp"
#include "grid_block.hpp"
#include "primitive.hpp"

namespace aerostat::bvh {
namespace {

void check_grid(const GridMesh& mesh, const BuildOptions& options) {
  check_input(mesh.triangles.size(), options);
  if (options.max_leaf_triangles < 2)
    throw Error(ErrorKind::internal, "building a BVH over a grid: a leaf must hold two triangles");
  const std::uint64_t columns = mesh.columns, rows = mesh.rows;
  const bool fits = columns < AERO_BVH_FIRST_MASK && rows < AERO_BVH_FIRST_MASK &&
                    mesh.triangles.size() == 2 * columns * rows &&
                    mesh.positions.size() >= (columns + 1) * (rows + 1);
  if (fits) return;
  throw Error(ErrorKind::internal, "building a BVH: " + std::to_string(mesh.triangles.size()) +
                                       " triangles over " + std::to_string(mesh.positions.size()) +
                                       " vertices are no grid of " + std::to_string(columns) +
                                       " x " + std::to_string(rows) + " cells");
}

/// A tree over the blocks of a grid and, under its leaves, the blocks' own nodes.
class GridBuilder {
 public:
  GridBuilder(const GridMesh& mesh, const BuildOptions& options) : mesh_(mesh), options_(options) {}

  Bvh build() {
    survey();
    Bvh bvh;
    bvh.nodes = top();
    place(static_cast<std::uint32_t>(bvh.nodes.size()));
    const std::size_t top_nodes = bvh.nodes.size();
    bvh.nodes.resize(places_.back().node);
    bvh.order.resize(places_.back().slot);
    emit(bvh);
    for (std::size_t n = 0; n < top_nodes; ++n) {
      for (aero_uint& child : bvh.nodes[n].child) {
        if (child == AERO_BVH_EMPTY || (child & AERO_BVH_LEAF) == 0) continue;
        child = places_[child & AERO_BVH_FIRST_MASK].reference;
      }
    }
    bvh.bounds = to_bounds(blocks_.bounds);
    bvh.stats.input_triangles = mesh_.triangles.size();
    bvh.stats.dropped_non_finite = blocks_.non_finite;
    bvh.stats.dropped_degenerate = blocks_.degenerate;
    return bvh;
  }

 private:
  // Where the nodes and triangles of a block begin, and what refers to it.
  struct Place {
    std::uint32_t node = 0, slot = 0, reference = 0;
  };

  // Boxes and plans of all blocks; blocks_ leaves out empty ones.
  void survey() {
    const std::size_t count = std::size_t{mesh_.block_columns()} * mesh_.block_rows();
    plans_.resize(count);
    blocks_.items = std::make_unique_for_overwrite<Primitive[]>(count);
    std::vector<std::uint32_t> non_finite(count), degenerate(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      const GridBlock block(mesh_, static_cast<std::uint32_t>(i));
      plans_[i] = block.plan();
      store_box(blocks_.items[i], block.bounds());
      blocks_.items[i].triangle = static_cast<std::uint32_t>(i);
      blocks_.items[i].unused = 0;
      non_finite[i] = block.non_finite();
      degenerate[i] = block.degenerate();
    });
    for (std::size_t i = 0; i < count; ++i) {
      blocks_.non_finite += non_finite[i];
      blocks_.degenerate += degenerate[i];
      if (plans_[i].triangles == 0) continue;
      blocks_.items[blocks_.count] = blocks_.items[i];
      const Box box = load_box(blocks_.items[blocks_.count++]);
      blocks_.bounds.grow(box);
      blocks_.centroids.grow(box.half_centre());
    }
  }

  // The nodes over the blocks, whose numbers in the new order stand in the leaves.
  std::vector<AeroBvhNode> top() {
    BuildOptions options = options_;
    options.max_leaf_triangles = 1;
    const BinaryTree tree = build_binary(blocks_, options);
    return collapse(tree, blocks_, options, kStackBudget - kBlockStack + 1);
  }

  void place(std::uint32_t first_node) {
    places_.resize(std::size_t{blocks_.count} + 1);
    Place next{first_node, 0, 0};
    for (std::uint32_t k = 0; k < blocks_.count; ++k) {
      places_[k] = next;
      const BlockPlan& plan = plans_[blocks_.items[k].triangle];
      next.node += plan.nodes;
      next.slot += plan.triangles;
    }
    places_.back() = next;
  }

  void emit(Bvh& bvh) {
    tbb::parallel_for(std::uint32_t{0}, blocks_.count, [&](std::uint32_t k) {
      const std::uint32_t number = blocks_.items[k].triangle;
      Place& at = places_[k];
      at.reference =
          GridBlock(mesh_, number)
              .emit(plans_[number], bvh.nodes.data(), at.node, bvh.order.data(), at.slot);
    });
  }

  const GridMesh& mesh_;
  const BuildOptions& options_;
  std::vector<BlockPlan> plans_;
  PrimitiveSet blocks_;
  std::vector<Place> places_;
};

}  // namespace

Bvh build_grid(std::span<const vec3> positions, std::span<const uvec3> triangles,
               std::uint32_t columns, std::uint32_t rows, const BuildOptions& options) {
  const GridMesh mesh{positions, triangles, columns, rows};
  check_grid(mesh, options);
  const auto start = std::chrono::steady_clock::now();
  Bvh bvh = GridBuilder(mesh, options).build();
  measure(bvh.nodes, bvh.bounds, options, bvh.stats);
  // Heights that grow geometrically can make a top too deep for two levels below it.
  if (bvh.stats.stack_entries > kStackBudget) bvh = build(positions, triangles, options);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  bvh.stats.seconds = elapsed.count();
  return bvh;
}

}  // namespace aerostat::bvh
