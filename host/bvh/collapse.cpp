#include "collapse.hpp"

#include <algorithm>
#include <array>

#include <tbb/parallel_for.h>

namespace aerostat::bvh {
namespace {

// One task folds each subtree of fewer primitives than this.
constexpr std::uint32_t kTaskCount = std::uint32_t{1} << 15;

constexpr bool is_inner(std::uint32_t child) {
  return (child & AERO_BVH_LEAF) == 0;
}

constexpr bool is_patch(std::uint32_t child) {
  return (child & (AERO_BVH_LEAF | AERO_BVH_PATCH)) == (AERO_BVH_LEAF | AERO_BVH_PATCH);
}

struct Children {
  std::array<Subtree, kWidth> item;
  int count = 0;

  void push(const Subtree& s) { item[static_cast<std::size_t>(count++)] = s; }
};

// A wide node to be made: its subtree, its index and the number of stack entries that are left.
struct Job {
  Subtree subtree;
  std::uint32_t index = 0;
  int budget = 0;
};

// A subtree that is left to a task of its own, and the child slot that will refer to it.
struct Deferred {
  Job job;
  std::uint32_t parent = 0;
  int slot = 0;
};

class Folder {
 public:
  Folder(const BinaryTree& tree, const PrimitiveSet& primitives, const BuildOptions& options)
      : tree_(tree), primitives_(primitives), options_(options) {}

  // Makes all nodes under `root` except those of deferred subtrees. A subtree of fewer than
  // `defer_below` primitives is deferred. The value 0 defers none.
  std::vector<AeroBvhNode> fold(Job root, std::uint32_t defer_below,
                                std::vector<Deferred>& deferred) const {
    std::vector<AeroBvhNode> nodes;
    nodes.push_back(empty_node());
    std::vector<Job> open{root};
    while (!open.empty()) {
      const Job job = open.back();
      open.pop_back();
      const Step step = open_up(job);
      for (int i = 0; i < step.children.count; ++i) {
        const Subtree& child = step.children.item[static_cast<std::size_t>(i)];
        std::uint32_t reference = leaf_reference(child);
        if (!is_leaf(child, step.by_plan)) {
          reference = static_cast<std::uint32_t>(nodes.size());
          const Job next{child, reference, job.budget - (step.children.count - 1)};
          if (child.count < defer_below) {
            deferred.push_back({next, job.index, i});
          } else {
            nodes.push_back(empty_node());
            open.push_back(next);
          }
        }
        set_child(nodes[job.index], i, bounds_of(child), reference);
      }
    }
    return nodes;
  }

 private:
  struct Step {
    Children children;
    bool by_plan = true;
  };

  Plan plan(const Subtree& s) const { return Plan(tree_.nodes[s.node].plan); }

  Step open_up(const Job& job) const {
    Step step;
    if (job.subtree.count == 1) {
      step.children.push(job.subtree);
      return step;
    }
    step.by_plan = plan(job.subtree).stack() <= job.budget;
    if (step.by_plan) {
      spread(job.subtree, kWidth, step.children);
    } else {
      descend(job.subtree, 3, step.children);
    }
    return step;
  }

  void spread(const Subtree& s, int slots, Children& out) const {
    int left = 0;
    while (s.count > 1 && slots > 1 && (left = plan(s).left_slots(slots)) == 0) --slots;
    if (s.count == 1 || slots == 1) return out.push(s);
    spread(tree_.left(s), left, out);
    spread(tree_.right(s), slots - left, out);
  }

  void descend(const Subtree& s, int levels, Children& out) const {
    if (levels == 0 || (levels < 3 && s.count <= options_.max_leaf_triangles)) return out.push(s);
    descend(tree_.left(s), levels - 1, out);
    descend(tree_.right(s), levels - 1, out);
  }

  bool is_leaf(const Subtree& s, bool by_plan) const {
    if (s.count == 1) return true;
    return by_plan ? plan(s).is_leaf() : s.count <= options_.max_leaf_triangles;
  }

  static std::uint32_t leaf_reference(const Subtree& s) {
    return AERO_BVH_LEAF | ((s.count - 1) << AERO_BVH_COUNT_SHIFT) | s.first;
  }

  Bounds bounds_of(const Subtree& s) const {
    if (s.count > 1) return bounds_of(tree_.nodes[s.node]);
    return bounds_of(primitives_.items[s.first]);
  }

  template <typename Record>
  static Bounds bounds_of(const Record& r) {
    return {{r.lo[0], r.lo[1], r.lo[2]}, {r.hi[0], r.hi[1], r.hi[2]}};
  }

  const BinaryTree& tree_;
  const PrimitiveSet& primitives_;
  const BuildOptions& options_;
};

void append_shifted(const std::vector<AeroBvhNode>& part, std::uint32_t offset, AeroBvhNode* out) {
  for (const AeroBvhNode& node : part) {
    AeroBvhNode& copy = *out++ = node;
    for (aero_uint& child : copy.child) {
      if (is_inner(child)) child += offset;
    }
  }
}

struct NodeSums {
  std::uint64_t children = 0;
  std::uint64_t leaves = 0;
  double area_cost = 0.0;

  void operator+=(const NodeSums& other) {
    children += other.children;
    leaves += other.leaves;
    area_cost += other.area_cost;
  }
};

// Blocks have a fixed size, so that sums do not depend on the distribution of blocks to threads.
constexpr std::size_t kSumBlock = 4096;

double half_area(const AeroBvhNode& node, int slot) {
  double d[3];
  for (int axis = 0; axis < 3; ++axis)
    d[axis] = static_cast<double>(node.hi[axis][slot]) - static_cast<double>(node.lo[axis][slot]);
  return d[0] * (d[1] + d[2]) + d[1] * d[2];
}

NodeSums sum_children(const AeroBvhNode& node, const BuildOptions& options) {
  NodeSums sums;
  for (int i = 0; i < kWidth; ++i) {
    const aero_uint child = node.child[i];
    if (child == AERO_BVH_EMPTY) continue;
    ++sums.children;
    if (is_patch(child)) continue;
    const aero_uint triangles = ((child >> AERO_BVH_COUNT_SHIFT) & AERO_BVH_COUNT_MASK) + 1;
    const double cost = is_inner(child)
                            ? static_cast<double>(options.traversal_cost)
                            : triangles * static_cast<double>(options.intersection_cost);
    sums.area_cost += half_area(node, i) * cost;
    if (!is_inner(child)) ++sums.leaves;
  }
  return sums;
}

// Returns the stack entries that the tree needs. Children come after their parents, so that in
// reverse order every child is known before its parent.
std::uint32_t measure_stack(const std::vector<AeroBvhNode>& nodes) {
  std::vector<std::uint16_t> need(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    int children = 0, deepest = 0;
    for (const aero_uint child : nodes[i].child) {
      if (child == AERO_BVH_EMPTY) continue;
      ++children;
      if (is_inner(child)) deepest = std::max<int>(deepest, need[child]);
    }
    need[i] = static_cast<std::uint16_t>(std::max(1, stack_of_node(children, deepest)));
  }
  return need[0];
}

}  // namespace

AeroBvhNode empty_node() {
  AeroBvhNode node;
  std::fill_n(&node.lo[0][0], 3 * kWidth, kInfinity);
  std::fill_n(&node.hi[0][0], 3 * kWidth, -kInfinity);
  std::fill_n(node.child, kWidth, AERO_BVH_EMPTY);
  std::fill_n(node.slope, kWidth, AERO_SLOPE_UNKNOWN);
  return node;
}

void set_child(AeroBvhNode& node, int slot, const Bounds& bounds, std::uint32_t reference) {
  for (int axis = 0; axis < 3; ++axis) {
    node.lo[axis][slot] = bounds.lo[axis];
    node.hi[axis][slot] = bounds.hi[axis];
  }
  node.child[slot] = reference;
}

std::vector<AeroBvhNode> collapse(const BinaryTree& tree, const PrimitiveSet& primitives,
                                  const BuildOptions& options, int stack_budget) {
  if (primitives.count == 0) return {empty_node()};
  const Folder folder(tree, primitives, options);
  std::vector<Deferred> deferred;
  std::vector<AeroBvhNode> nodes =
      folder.fold({{0, 0, primitives.count}, 0, stack_budget}, kTaskCount, deferred);
  std::vector<std::vector<AeroBvhNode>> parts(deferred.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    std::vector<Deferred> none;
    Job job = deferred[i].job;
    job.index = 0;
    parts[i] = folder.fold(job, 0, none);
  });
  std::vector<std::uint32_t> offset(parts.size());
  std::size_t total = nodes.size();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    offset[i] = static_cast<std::uint32_t>(total);
    nodes[deferred[i].parent].child[deferred[i].slot] = offset[i];
    total += parts[i].size();
  }
  nodes.resize(total);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    append_shifted(parts[i], offset[i], nodes.data() + offset[i]);
  });
  return nodes;
}

void measure(const std::vector<AeroBvhNode>& nodes, const Bounds& bounds,
             const BuildOptions& options, BuildStats& stats) {
  AeroBvhNode root = empty_node();
  set_child(root, 0, bounds, 0);
  const double root_area = half_area(root, 0);
  double area_cost = root_area * static_cast<double>(options.traversal_cost);
  std::vector<NodeSums> blocks((nodes.size() + kSumBlock - 1) / kSumBlock);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    const std::size_t end = std::min((b + 1) * kSumBlock, nodes.size());
    for (std::size_t i = b * kSumBlock; i < end; ++i) blocks[b] += sum_children(nodes[i], options);
  });
  std::uint64_t children = 0;
  for (const NodeSums& sums : blocks) {
    children += sums.children;
    stats.leaves += sums.leaves;
    area_cost += sums.area_cost;
  }
  stats.nodes = nodes.size();
  stats.sah_cost = root_area > 0.0 && children > 0 ? area_cost / root_area : 0.0;
  stats.stack_entries = measure_stack(nodes);
}

}  // namespace aerostat::bvh
