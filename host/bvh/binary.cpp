#include "binary.hpp"

#include <tbb/parallel_invoke.h>

#include "core/huge_pages.hpp"
#include "split.hpp"
#include "sweep.hpp"

namespace aerostat::bvh {
namespace {

constexpr std::uint32_t kTaskCount = 4096;

class Builder {
 public:
  Builder(Primitive* primitives, BinaryNode* nodes, const BuildOptions& options)
      : primitives_(primitives), nodes_(nodes), options_(options) {}

  Forest build(const Subtree& s, int depth, const Box& bounds, const Box& centroids) const {
    const std::span<Primitive> range(primitives_ + s.first, s.count);
    if (s.count <= kSweepCount) return sweep(range, nodes_ + s.node, depth, options_);
    const Parts parts = split(range, depth, centroids);
    BinaryNode& node = nodes_[s.node];
    store_box(node, bounds);
    node.left_count = parts.left_count;
    const Forest forest = build_children(s, depth, parts, bounds);
    return forest;
  }

 private:
  Parts split(std::span<Primitive> range, int depth, const Box& centroids) const {
    if (!must_halve(depth, static_cast<std::uint32_t>(range.size()))) {
      if (const auto parts = split_binned(range, centroids)) return *parts;
    }
    return split_halves(range, centroids);
  }

  Forest build_children(const Subtree& s, int depth, const Parts& parts, const Box& bounds) const {
    const std::uint32_t n = parts.left_count;
    Forest left, right;
    const auto build_left = [&] {
      left = build({s.node + 1, s.first, n}, depth + 1, parts.bounds[0], parts.centroids[0]);
    };
    const auto build_right = [&] {
      right = build({s.node + n, s.first + n, s.count - n}, depth + 1, parts.bounds[1],
                    parts.centroids[1]);
    };
    if (s.count >= kTaskCount) {
      tbb::parallel_invoke(build_left, build_right);
    } else {
      build_left();
      build_right();
    }
    Plan plan;
    const Forest forest = combine(left, right, bounds.half_area(), s.count, options_, plan);
    nodes_[s.node].plan = plan.bits();
    return forest;
  }

  Primitive* primitives_;
  BinaryNode* nodes_;
  const BuildOptions& options_;
};

}  // namespace

BinaryTree build_binary(PrimitiveSet& primitives, const BuildOptions& options) {
  BinaryTree tree;
  if (primitives.count < 2) return tree;
  tree.nodes = std::make_unique_for_overwrite<BinaryNode[]>(primitives.count - 1);
  prefer_huge_pages(tree.nodes.get(), (primitives.count - 1) * sizeof(BinaryNode));
  const Builder builder(primitives.items.get(), tree.nodes.get(), options);
  builder.build({0, 0, primitives.count}, 0, primitives.bounds, primitives.centroids);
  return tree;
}

}  // namespace aerostat::bvh
