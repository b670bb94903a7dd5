#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include <tbb/parallel_for.h>

#include "bvh.hpp"
#include "collapse.hpp"
#include "core/error.hpp"

namespace aerostat::bvh {
namespace {

Bounds united(const Bounds& a, const Bounds& b) {
  return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

double half_area(const Bounds& b) {
  const dvec3 d = dvec3(b.hi) - dvec3(b.lo);
  return d.x * (d.y + d.z) + d.y * d.z;
}

bool is_slot_leaf(aero_uint child) {
  return (child & AERO_BVH_LEAF) != 0 && (child & AERO_BVH_PATCH) == 0;
}

bool is_instance(aero_uint child) {
  return (child & AERO_BVH_LEAF) != 0 && (child & AERO_BVH_PATCH) != 0 &&
         (child >> AERO_PATCH_SHAPE_SHIFT & AERO_PATCH_SHAPE_MASK) == AERO_PATCH_INSTANCE;
}

// A part and where it begins in the result.
struct Entry : Part {
  std::uint32_t first_node = 0;
  std::uint32_t first_slot = 0;
};

// The data of a subtree of the common top that its parent needs.
struct Top {
  Bounds bounds;
  std::uint32_t reference = 0;
  int stack = 0;
  double area_cost = 0.0;
};

class Joiner {
 public:
  explicit Joiner(std::span<const Part> parts) {
    for (const Part& part : parts) {
      // Nothing is to be found in an empty tree, but instances may refer to an empty model.
      if (!part.is_model && part.tree->stats.leaves == 0) continue;
      if (!part.is_model) trees_.push_back(entries_.size());
      entries_.push_back({part});
    }
  }

  JoinedBvh join() {
    std::size_t slots = 0;
    const Top root = trees_.empty() ? no_trees() : raise(0, trees_.size());
    for (Entry& entry : entries_) {
      entry.first_slot = static_cast<std::uint32_t>(slots);
      slots += entry.tree->slots;
      check_addressable(slots);
    }
    const bool ordered = std::all_of(entries_.begin(), entries_.end(), [](const Entry& entry) {
      return entry.tree->order.size() == entry.tree->slots;
    });
    if (ordered) result_.order.resize(slots);
    result_.slots = static_cast<std::uint32_t>(slots);
    place_trees();
    for (const Entry& entry : entries_) {
      if (entry.is_model) result_.model_roots.push_back(entry.first_node);
    }
    result_.bounds = root.bounds;
    result_.stats.nodes = result_.nodes.size();
    result_.stats.stack_entries = static_cast<std::uint32_t>(root.stack);
    const double area = half_area(root.bounds);
    result_.stats.sah_cost = area > 0.0 ? root.area_cost / area : 0.0;
    return std::move(result_);
  }

 private:
  static void check_addressable(std::size_t triangles) {
    if (triangles <= std::size_t{AERO_BVH_FIRST_MASK} + 1) return;
    throw Error(ErrorKind::bad_data, "joining BVHs: " + std::to_string(triangles) +
                                         " triangles, expected at most " +
                                         std::to_string(std::size_t{AERO_BVH_FIRST_MASK} + 1));
  }

  Top no_trees() {
    result_.nodes.push_back(empty_node());
    tree_children_.push_back(0);
    return {{}, 0, 1, 0.0};
  }

  // Makes the nodes above trees [begin, end). References to trees are the numbers of their entries
  // until place_trees() knows how many nodes come before them.
  Top raise(std::size_t begin, std::size_t end) {
    if (end - begin == 1) return top_of_tree(begin);
    Top top{{}, static_cast<std::uint32_t>(result_.nodes.size()), 0, 0.0};
    result_.nodes.push_back(empty_node());
    tree_children_.push_back(0);
    const std::size_t children = std::min<std::size_t>(end - begin, AERO_BVH_WIDTH);
    int deepest = 0;
    for (std::size_t i = 0; i < children; ++i) {
      const std::size_t from = begin + (end - begin) * i / children;
      const std::size_t to = begin + (end - begin) * (i + 1) / children;
      const Top child = raise(from, to);
      const int slot = static_cast<int>(i);
      if (to - from == 1) tree_children_[top.reference] |= 1u << slot;
      set_child(result_.nodes[top.reference], slot, child.bounds, child.reference);
      top.bounds = united(top.bounds, child.bounds);
      top.area_cost += child.area_cost;
      deepest = std::max(deepest, child.stack);
    }
    top.stack = stack_of_node(static_cast<int>(children), deepest);
    top.area_cost += half_area(top.bounds) * static_cast<double>(BuildOptions().traversal_cost);
    return top;
  }

  Top top_of_tree(std::size_t i) const {
    const Bvh& tree = *entries_[trees_[i]].tree;
    return {tree.bounds, static_cast<std::uint32_t>(trees_[i]),
            static_cast<int>(tree.stats.stack_entries),
            tree.stats.sah_cost * half_area(tree.bounds)};
  }

  void place_trees() {
    const std::size_t top_nodes = result_.nodes.size();
    std::size_t total = top_nodes;
    for (Entry& entry : entries_) {
      entry.first_node = static_cast<std::uint32_t>(total);
      total += entry.tree->nodes.size();
    }
    result_.nodes.resize(total);
    for (std::size_t n = 0; n < top_nodes; ++n) {
      for (int slot = 0; slot < AERO_BVH_WIDTH; ++slot) {
        aero_uint& child = result_.nodes[n].child[slot];
        if ((tree_children_[n] >> slot & 1u) != 0) child = entries_[child].first_node;
      }
    }
    for (const Entry& entry : entries_) append(entry);
  }

  void append(const Entry& entry) {
    const auto& nodes = entry.tree->nodes;
    tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
      AeroBvhNode& node = result_.nodes[entry.first_node + i] = nodes[i];
      for (aero_uint& child : node.child) {
        if (is_slot_leaf(child)) child += entry.first_slot;
        if (is_instance(child)) child += entry.first_instance;
        if ((child & AERO_BVH_LEAF) == 0) child += entry.first_node;
      }
    });
    if (!result_.order.empty()) {
      std::transform(entry.tree->order.begin(), entry.tree->order.end(),
                     result_.order.begin() + entry.first_slot,
                     [&](std::uint32_t triangle) { return triangle + entry.first_triangle; });
    }
    result_.stats.leaves += entry.tree->stats.leaves;
  }

  std::vector<Entry> entries_;
  std::vector<std::size_t> trees_;            // entries that are no models
  std::vector<std::uint32_t> tree_children_;  // per node of the top: which slots hold trees
  JoinedBvh result_;
};

void add_counts(const BuildStats& from, BuildStats& to) {
  to.input_triangles += from.input_triangles;
  to.dropped_non_finite += from.dropped_non_finite;
  to.dropped_degenerate += from.dropped_degenerate;
  to.seconds += from.seconds;
}

}  // namespace

JoinedBvh join(std::span<const Part> parts) {
  JoinedBvh joined = Joiner(parts).join();
  for (const Part& part : parts) add_counts(part.tree->stats, joined.stats);
  if (joined.stats.stack_entries > AERO_BVH_STACK)
    throw Error(ErrorKind::internal, "joining BVHs: the result needs a stack of " +
                                         std::to_string(joined.stats.stack_entries) +
                                         " entries, the kernels have " +
                                         std::to_string(AERO_BVH_STACK));
  return joined;
}

}  // namespace aerostat::bvh
