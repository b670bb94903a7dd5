#include "sweep.hpp"

#include <algorithm>

namespace aerostat::bvh {
namespace {

// Sorts once by centroid along each axis; splits then keep the three orders by stable partition.
class Sweeper {
 public:
  Sweeper(std::span<const Primitive> range, BinaryNode* nodes, const BuildOptions& options)
      : nodes_(nodes), options_(options) {
    const int n = static_cast<int>(range.size());
    float centre[3][kSweepCount];
    for (int i = 0; i < n; ++i) {
      box_[i] = load_box(range[i]);
      const Float4 c = box_[i].half_centre();
      for (int axis = 0; axis < 3; ++axis) centre[axis][i] = c[axis];
    }
    for (int axis = 0; axis < 3; ++axis) sort(centre[axis], n, order_[axis]);
  }

  Forest build(int begin, int end, int node, int depth) {
    const int count = end - begin;
    if (count == 1) return single_forest(box_[order_[0][begin]].half_area(), options_);
    Box bounds;
    const int middle = split(begin, end, depth, bounds);
    BinaryNode& out = nodes_[node];
    store_box(out, bounds);
    out.left_count = static_cast<std::uint32_t>(middle - begin);
    const Forest left = build(begin, middle, node + 1, depth + 1);
    const Forest right = build(middle, end, node + (middle - begin), depth + 1);
    Plan plan;
    const Forest forest =
        combine(left, right, bounds.half_area(), static_cast<std::uint32_t>(count), options_, plan);
    out.plan = plan.bits();
    return forest;
  }

  // Which primitive of the range comes at place i.
  int at(int i) const { return order_[0][i]; }

 private:
  // Counts for each key how many come before it: no branch to mispredict, and it vectorises.
  static void sort(const float* key, int n, std::uint8_t* order) {
    std::int32_t rank[kSweepCount] = {};
    for (int i = 0; i < n; ++i) {
      std::int32_t before = 0;
      for (int j = 0; j < i; ++j) {
        const std::int32_t first = key[j] <= key[i] ? 1 : 0;
        before += first;
        rank[j] += 1 - first;
      }
      rank[i] += before;
    }
    for (int i = 0; i < n; ++i) order[rank[i]] = static_cast<std::uint8_t>(i);
  }

  // Reorders [begin, end) and returns the first place of the right part.
  int split(int begin, int end, int depth, Box& bounds) {
    int axis = 0, middle = (begin + end) / 2;
    float best_cost = kInfinity;
    bounds = scan_right(0, begin, end);
    if (end - begin == 2) return middle;
    if (must_halve(depth, static_cast<std::uint32_t>(end - begin))) {
      axis = bounds.widest_axis();
    } else {
      search_axis(0, begin, end, best_cost, axis, middle);
      for (int other = 1; other < 3; ++other) {
        scan_right(other, begin, end);
        search_axis(other, begin, end, best_cost, axis, middle);
      }
    }
    for (int i = begin; i < end; ++i) goes_left_[order_[axis][i]] = i < middle ? 1 : 0;
    for (int other = 0; other < 3; ++other) {
      if (other != axis) partition(order_[other], begin, end, middle);
    }
    return middle;
  }

  // Fills right_area_[i], the half area of places i .. end - 1, and returns the box of all.
  Box scan_right(int axis, int begin, int end) {
    Box box;
    for (int i = end - 1; i > begin; --i) {
      box.grow(box_[order_[axis][i]]);
      right_area_[i] = box.half_area();
    }
    box.grow(box_[order_[axis][begin]]);
    return box;
  }

  void search_axis(int axis, int begin, int end, float& best_cost, int& best_axis,
                   int& best) const {
    Box box;
    for (int i = begin + 1; i < end; ++i) {
      box.grow(box_[order_[axis][i - 1]]);
      const float cost = box.half_area() * static_cast<float>(i - begin) +
                         right_area_[i] * static_cast<float>(end - i);
      if (cost < best_cost) {
        best_cost = cost;
        best_axis = axis;
        best = i;
      }
    }
  }

  void partition(std::uint8_t* order, int begin, int end, int middle) const {
    std::uint8_t sorted[kSweepCount];
    int to[2] = {middle, begin};
    for (int i = begin; i < end; ++i) sorted[to[goes_left_[order[i]]]++] = order[i];
    std::copy(sorted + begin, sorted + end, order + begin);
  }

  BinaryNode* nodes_;
  const BuildOptions& options_;
  Box box_[kSweepCount];
  std::uint8_t order_[3][kSweepCount];
  std::uint8_t goes_left_[kSweepCount];
  float right_area_[kSweepCount];
};

}  // namespace

Forest sweep(std::span<Primitive> range, BinaryNode* nodes, int depth,
             const BuildOptions& options) {
  Sweeper sweeper(range, nodes, options);
  const int n = static_cast<int>(range.size());
  const Forest forest = sweeper.build(0, n, 0, depth);
  Primitive copy[kSweepCount];
  std::copy(range.begin(), range.end(), copy);
  for (int i = 0; i < n; ++i) range[i] = copy[sweeper.at(i)];
  return forest;
}

}  // namespace aerostat::bvh
