#include "grid.hpp"

#include <chrono>
#include <memory>
#include <vector>

#include <tbb/parallel_for.h>

#include "binary.hpp"
#include "collapse.hpp"
#include "grid_block.hpp"
#include "primitive.hpp"

namespace aerostat::bvh {
namespace {

/// The stack entries that a node of patches needs.
constexpr int kBlockStack = AERO_BVH_WIDTH;

/// Builds a tree over the blocks of a grid and replaces its leaves by the nodes of the blocks.
class GridBuilder {
 public:
  GridBuilder(const mesh::GridMesh& grid, const BuildOptions& options)
      : grid_(grid),
        options_(options),
        across_((grid.columns() + kBlockSide - 1) / kBlockSide),
        count_(across_ * ((grid.rows() + kBlockSide - 1) / kBlockSide)) {}

  Bvh build() {
    survey();
    Bvh bvh;
    bvh.nodes = top();
    add_block_nodes(bvh.nodes);
    bvh.bounds = to_bounds(blocks_.bounds);
    bvh.stats.input_triangles = grid_.triangles();
    measure(bvh.nodes, bvh.bounds, options_, bvh.stats);
    add_cells(bvh);
    return bvh;
  }

 private:
  GridBlock block(std::uint32_t number) const {
    return {grid_, number % across_ * kBlockSide, number / across_ * kBlockSide};
  }

  void survey() {
    plans_.resize(count_);
    block_nodes_ = std::make_unique_for_overwrite<AeroBvhNode[]>(count_);
    blocks_.items = std::make_unique_for_overwrite<Primitive[]>(count_);
    blocks_.count = count_;
    tbb::parallel_for(std::uint32_t{0}, count_, [&](std::uint32_t i) {
      const GridBlock surveyed = block(i);
      plans_[i] = surveyed.plan();
      block_nodes_[i] = surveyed.node(plans_[i]);
      store_box(blocks_.items[i], surveyed.bounds());
      blocks_.items[i].triangle = i;
      blocks_.items[i].unused = 0;
    });
    for (std::uint32_t i = 0; i < count_; ++i) {
      const Box box = load_box(blocks_.items[i]);
      blocks_.bounds.grow(box);
      blocks_.centroids.grow(box.half_centre());
    }
  }

  // Returns the nodes over the blocks. The leaves hold the numbers of the blocks in their new
  // order.
  std::vector<AeroBvhNode> top() {
    BuildOptions options = options_;
    options.max_leaf_triangles = 1;
    const BinaryTree tree = build_binary(blocks_, options);
    return collapse(tree, blocks_, options, kStackBudget - kBlockStack + 1);
  }

  void add_block_nodes(std::vector<AeroBvhNode>& nodes) const {
    const auto first = static_cast<std::uint32_t>(nodes.size());
    for (AeroBvhNode& node : nodes) {
      for (aero_uint& child : node.child) {
        if (child == AERO_BVH_EMPTY || (child & AERO_BVH_LEAF) == 0) continue;
        child = first + (child & AERO_BVH_FIRST_MASK);
      }
    }
    nodes.resize(std::size_t{first} + count_);
    tbb::parallel_for(std::uint32_t{0}, count_, [&](std::uint32_t k) {
      nodes[first + k] = block_nodes_[blocks_.items[k].triangle];
    });
    for (std::uint32_t n = first; n-- > 0;) know_slopes(nodes, n);
  }

  // Computes the slopes of the children of a node. Children come after their parents, so that in
  // reverse order every child is known before its parent.
  static void know_slopes(std::vector<AeroBvhNode>& nodes, std::uint32_t n) {
    for (int slot = 0; slot < AERO_BVH_WIDTH; ++slot) {
      if (nodes[n].child[slot] == AERO_BVH_EMPTY) continue;
      const AeroBvhNode& child = nodes[nodes[n].child[slot]];
      std::uint32_t slopes = child.slope[0];
      for (int i = 1; i < AERO_BVH_WIDTH && child.child[i] != AERO_BVH_EMPTY; ++i)
        slopes = united_slopes(slopes, child.slope[i]);
      nodes[n].slope[slot] = slopes;
    }
  }

  // Adds the statistics of patches and cells, which measure() cannot know. A patch is a node
  // without memory over cells of two triangles.
  void add_cells(Bvh& bvh) const {
    double area_cost = 0.0;
    for (const BlockPlan& plan : plans_) {
      const float patches = plan.patch_area * options_.traversal_cost;
      area_cost +=
          static_cast<double>(patches + plan.cell_area * 2.0f * options_.intersection_cost);
    }
    bvh.stats.sah_cost += area_cost / static_cast<double>(blocks_.bounds.half_area());
    bvh.stats.leaves = std::uint64_t{grid_.columns()} * grid_.rows();
  }

  const mesh::GridMesh& grid_;
  const BuildOptions& options_;
  std::uint32_t across_, count_;
  std::vector<BlockPlan> plans_;
  std::unique_ptr<AeroBvhNode[]> block_nodes_;  // indexed by block
  PrimitiveSet blocks_;
};

}  // namespace

Bvh build_grid(const mesh::GridMesh& grid, const BuildOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Bvh bvh = GridBuilder(grid, options).build();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  bvh.stats.seconds = elapsed.count();
  return bvh;
}

}  // namespace aerostat::bvh
