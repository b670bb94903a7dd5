#include "forest.hpp"

#include <algorithm>

namespace aerostat::bvh {
namespace {

struct Distribution {
  float cost = kInfinity;
  int left = 0;
};

// The best way to give `slots` subtrees to two children.
Distribution distribute(const Forest& left, const Forest& right, int slots) {
  Distribution best{kInfinity, slots / 2};
  for (int k = std::max(1, slots - kWidth + 1); k <= std::min(kWidth - 1, slots - 1); ++k) {
    const float cost = left.cost[k] + right.cost[slots - k];
    if (cost < best.cost) best = {cost, k};
  }
  return best;
}

// The subtree in one slot: a wide node, or a leaf if that is no dearer.
void fill_root(Forest& forest, const Forest& left, const Forest& right, float half_area,
               std::uint32_t count, const BuildOptions& options, Plan& plan) {
  const Distribution all = distribute(left, right, kWidth);
  const int right_slots = kWidth - all.left;
  const int stack = stack_of_node(left.used[all.left] + right.used[right_slots],
                                  std::max(left.stack[all.left], right.stack[right_slots]));
  plan.set_left_slots(kWidth, all.left);
  plan.set_stack(stack);
  forest.used[1] = 1;
  forest.cost[1] = all.cost + half_area * options.traversal_cost;
  forest.stack[1] = static_cast<std::uint16_t>(stack);
  const float leaf_cost = half_area * static_cast<float>(count) * options.intersection_cost;
  if (count > options.max_leaf_triangles || forest.cost[1] < leaf_cost) return;
  plan.set_leaf();
  forest.cost[1] = leaf_cost;
  forest.stack[1] = 0;
}

}  // namespace

Forest single_forest(float half_area, const BuildOptions& options) {
  Forest forest;
  for (int i = 0; i < kWidth; ++i) {
    forest.cost[i] = half_area * options.intersection_cost;
    forest.stack[i] = 0;
    forest.used[i] = 1;
  }
  return forest;
}

Forest combine(const Forest& left, const Forest& right, float half_area, std::uint32_t count,
               const BuildOptions& options, Plan& plan) {
  Forest forest;
  fill_root(forest, left, right, half_area, count, options, plan);
  for (int i = 2; i < kWidth; ++i) {
    const Distribution d = distribute(left, right, i);
    if (d.cost < forest.cost[i - 1]) {
      const int right_slots = i - d.left;
      plan.set_left_slots(i, d.left);
      forest.cost[i] = d.cost;
      forest.stack[i] = std::max(left.stack[d.left], right.stack[right_slots]);
      forest.used[i] = static_cast<std::uint8_t>(left.used[d.left] + right.used[right_slots]);
    } else {
      forest.cost[i] = forest.cost[i - 1];
      forest.stack[i] = forest.stack[i - 1];
      forest.used[i] = forest.used[i - 1];
    }
  }
  return forest;
}

}  // namespace aerostat::bvh
