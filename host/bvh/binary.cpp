#include "binary.hpp"

#include <tbb/parallel_invoke.h>

#include "loops.hpp"
#include "small_tree.hpp"
#include "split.hpp"

namespace aerostat::bvh {
namespace {

constexpr std::uint32_t kTaskCount = 4096;

class Builder {
 public:
  Builder(Primitive* primitives, BinaryNode* nodes, const BuildOptions& options)
      : primitives_(primitives), nodes_(nodes), options_(options) {}

  void build(const Subtree& s, int depth, const Box& bounds, const Box& centroids,
             Forest& forest) const {
    if (s.count == 1) {
      forest = single_forest(bounds.half_area(), options_);
      return;
    }
    if (s.count <= kSmallCount) {
      loops_.build_small(primitives_ + s.first, static_cast<int>(s.count), nodes_ + s.node, depth,
                         options_, forest);
      return;
    }
    const Parts parts = split({primitives_ + s.first, s.count}, depth, centroids);
    BinaryNode& node = nodes_[s.node];
    store_box(node, bounds);
    node.left_count = parts.left_count;
    build_children(s, depth, parts, bounds, forest);
  }

 private:
  Parts split(std::span<Primitive> range, int depth, const Box& centroids) const {
    if (!must_halve(depth, static_cast<std::uint32_t>(range.size()))) {
      if (const auto parts = split_binned(range, centroids)) return *parts;
    }
    return split_halves(range, centroids);
  }

  void build_children(const Subtree& s, int depth, const Parts& parts, const Box& bounds,
                      Forest& forest) const {
    const std::uint32_t n = parts.left_count;
    Forest left, right;
    const auto build_left = [&] {
      build({s.node + 1, s.first, n}, depth + 1, parts.bounds[0], parts.centroids[0], left);
    };
    const auto build_right = [&] {
      build({s.node + n, s.first + n, s.count - n}, depth + 1, parts.bounds[1], parts.centroids[1],
            right);
    };
    if (s.count >= kTaskCount) {
      tbb::parallel_invoke(build_left, build_right);
    } else {
      build_left();
      build_right();
    }
    Plan plan;
    loops_.combine(left, right, bounds.half_area(), s.count, options_, forest, plan);
    nodes_[s.node].plan = plan.bits();
  }

  Primitive* primitives_;
  BinaryNode* nodes_;
  const BuildOptions& options_;
  const Loops& loops_ = loops();
};

}  // namespace

BinaryTree build_binary(PrimitiveSet& primitives, const BuildOptions& options) {
  BinaryTree tree;
  if (primitives.count < 2) return tree;
  tree.nodes = std::make_unique_for_overwrite<BinaryNode[]>(primitives.count - 1);
  const Builder builder(primitives.items.get(), tree.nodes.get(), options);
  Forest forest;
  builder.build({0, 0, primitives.count}, 0, primitives.bounds, primitives.centroids, forest);
  return tree;
}

}  // namespace aerostat::bvh
