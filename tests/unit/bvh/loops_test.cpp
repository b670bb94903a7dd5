#include "bvh/loops.hpp"

#include <algorithm>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "bvh/few.hpp"
#include "bvh/ranks.hpp"
#include "bvh/small_tree.hpp"
#include "support/bvh_meshes.hpp"

namespace aerostat {
namespace {

using bvh::Box;
using bvh::Float8;
using bvh::Primitive;

std::vector<Primitive> primitives(std::size_t count, unsigned seed) {
  const test::Soup soup = test::random_soup(count, seed);
  const bvh::PrimitiveSet set = bvh::collect_primitives(soup.positions, soup.triangles);
  return {set.items.get(), set.items.get() + set.count};
}

Box centroids_of(const std::vector<Primitive>& items) {
  Box box;
  for (const Primitive& item : items) box.grow(bvh::load_box(item).half_centre());
  return box;
}

template <typename T>
bool same(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

bool same(const std::vector<Primitive>& a, const std::vector<Primitive>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

void expect_same(const bvh::Bins& a, const bvh::Bins& b) {
  for (int i = 0; i < a.count; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(same(a.bin[i].box[axis], b.bin[i].box[axis])) << i << ", axis " << axis;
      EXPECT_EQ(a.bin[i].held[axis], b.bin[i].held[axis]) << i << ", axis " << axis;
    }
  }
}

// Checks the list that the other tests rely on: the plain loops come first and the chosen ones
// last.
TEST(BvhLoops, ArePlainFirstAndChosenLast) {
  ASSERT_FALSE(bvh::all_loops().empty());
  EXPECT_EQ(bvh::all_loops().back(), &bvh::loops());
}

TEST(BvhLoops, OfAllWidthsSplitAlike) {
  for (const std::size_t count : {17u, 31u, 32u, 33u, 64u, 1000u, 5001u}) {
    SCOPED_TRACE(count);
    const auto items = primitives(count, static_cast<unsigned>(count));
    const bvh::BinMap map(centroids_of(items), count > 100 ? 32 : 16);
    bvh::Bins expected(map.bins);
    Box expected_bounds[2], expected_centroids[2];
    std::vector<Primitive> expected_items = items;
    const bvh::Loops& plain = *bvh::all_loops().front();
    plain.fill(expected, items.data(), count, map);
    const bvh::Plane plane = plain.search(expected, expected_bounds);
    ASSERT_GE(plane.axis, 0);
    const std::size_t left =
        plain.partition(expected_items.data(), count, map, plane, expected_centroids);
    for (const bvh::Loops* loops : bvh::all_loops()) {
      bvh::Bins bins(map.bins);
      Box bounds[2], centroids[2];
      std::vector<Primitive> own = items;
      loops->fill(bins, items.data(), count, map);
      expect_same(bins, expected);
      EXPECT_TRUE(same(loops->search(bins, bounds), plane));
      EXPECT_EQ(loops->partition(own.data(), count, map, plane, centroids), left);
      EXPECT_TRUE(same(own, expected_items));
      for (int side = 0; side < 2; ++side) {
        EXPECT_TRUE(same(bounds[side], expected_bounds[side]));
        EXPECT_TRUE(same(centroids[side], expected_centroids[side]));
      }
    }
  }
}

TEST(BvhLoops, PartitionAsTheBinsSay) {
  const auto items = primitives(2000, 5);
  const bvh::BinMap map(centroids_of(items), 32);
  for (const bvh::Loops* loops : bvh::all_loops()) {
    bvh::Bins bins(map.bins);
    Box bounds[2], centroids[2];
    std::vector<Primitive> own = items;
    loops->fill(bins, items.data(), items.size(), map);
    const bvh::Plane plane = loops->search(bins, bounds);
    const std::size_t left = loops->partition(own.data(), own.size(), map, plane, centroids);
    int held = 0;
    for (int i = 0; i < plane.bin; ++i) held += bins.bin[i].held[plane.axis];
    EXPECT_EQ(left, static_cast<std::size_t>(held));
    Box seen[2], seen_centroids[2];
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Box box = bvh::load_box(own[i]);
      seen[i < left ? 0 : 1].grow(box);
      seen_centroids[i < left ? 0 : 1].grow(box.half_centre());
    }
    for (int side = 0; side < 2; ++side) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(seen[side].lo[axis], bounds[side].lo[axis]);
        EXPECT_EQ(seen[side].hi[axis], bounds[side].hi[axis]);
        EXPECT_EQ(seen_centroids[side].lo[axis], centroids[side].lo[axis]);
        EXPECT_EQ(seen_centroids[side].hi[axis], centroids[side].hi[axis]);
      }
    }
  }
}

TEST(BvhLoops, OfAllWidthsBuildTheSameSmallTrees) {
  for (int count = 2; count <= bvh::kSmallCount; ++count) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      for (const int depth : {0, bvh::kMaxDepth - 5}) {
        if (depth > 0 && bvh::must_halve(depth - 1, static_cast<std::uint32_t>(count))) continue;
        SCOPED_TRACE(testing::Message() << count << " primitives, seed " << seed);
        const auto items = primitives(static_cast<std::size_t>(count), seed);
        std::vector<Primitive> expected_items = items;
        std::vector<bvh::BinaryNode> expected(static_cast<std::size_t>(count - 1));
        bvh::Forest expected_forest;
        bvh::all_loops().front()->build_small(expected_items.data(), count, expected.data(), depth,
                                              {}, expected_forest);
        for (const bvh::Loops* loops : bvh::all_loops()) {
          std::vector<Primitive> own = items;
          std::vector<bvh::BinaryNode> nodes(expected.size());
          bvh::Forest forest;
          loops->build_small(own.data(), count, nodes.data(), depth, {}, forest);
          EXPECT_TRUE(same(own, expected_items));
          EXPECT_EQ(std::memcmp(nodes.data(), expected.data(), nodes.size() * sizeof(nodes[0])), 0);
          for (int lane = 0; lane + 1 < bvh::kWidth; ++lane) {
            EXPECT_EQ(forest.cost[lane], expected_forest.cost[lane]);
            EXPECT_EQ(forest.used[lane], expected_forest.used[lane]);
            EXPECT_EQ(forest.stack[lane], expected_forest.stack[lane]);
          }
        }
      }
    }
  }
}

// Returns a random forest in which more slots never cost more.
bvh::Forest random_forest(std::mt19937& random) {
  bvh::Forest forest;
  float cost = std::uniform_real_distribution<float>(1.0f, 2.0f)(random);
  for (int lane = 0; lane < bvh::kWidth; ++lane) {
    forest.cost[lane] = cost;
    forest.stack[lane] = static_cast<int>(random() % 40);
    forest.used[lane] = 1 + static_cast<int>(random() % static_cast<unsigned>(lane + 1));
    if (random() % 3 != 0) cost *= std::uniform_real_distribution<float>(0.7f, 1.0f)(random);
  }
  return forest;
}

// Returns the cost of the cheapest way to give `slots` to two children, found by trying every way.
float least_cost(const bvh::Forest& left, const bvh::Forest& right, int slots) {
  float least = kInfinity;
  for (int k = std::max(1, slots - 7); k <= std::min(7, slots - 1); ++k)
    least = std::min(least, left.cost[k - 1] + right.cost[slots - k - 1]);
  return least;
}

TEST(BvhLoops, CombineForestsAsTheirDefinitionSays) {
  std::mt19937 random(11);
  const bvh::BuildOptions options;
  for (int round = 0; round < 500; ++round) {
    SCOPED_TRACE(round);
    const bvh::Forest left = random_forest(random), right = random_forest(random);
    const float area = std::uniform_real_distribution<float>(0.1f, 3.0f)(random);
    const std::uint32_t count = 2 + static_cast<std::uint32_t>(random() % 6);
    for (const bvh::Loops* loops : bvh::all_loops()) {
      bvh::Forest forest;
      bvh::Plan plan;
      loops->combine(left, right, area, count, options, forest, plan);
      const float node = least_cost(left, right, 8) + area * options.traversal_cost;
      const float leaf = area * static_cast<float>(count) * options.intersection_cost;
      const bool is_leaf = count <= options.max_leaf_triangles && leaf <= node;
      const float root = is_leaf ? leaf : node;
      EXPECT_EQ(plan.is_leaf(), is_leaf);
      EXPECT_EQ(forest.cost[0], root);
      for (int slots = 2; slots <= 8; ++slots) {
        const float best = least_cost(left, right, slots);
        const int k = plan.left_slots(slots);
        if (slots < 8) {
          EXPECT_EQ(forest.cost[slots - 1], std::min(best, root));
          EXPECT_EQ(k == 0, best >= root);
        }
        if (k == 0) {
          EXPECT_EQ(forest.used[slots - 1], 1);
          continue;
        }
        EXPECT_EQ(left.cost[k - 1] + right.cost[slots - k - 1], best);
        const int used = left.used[k - 1] + right.used[slots - k - 1];
        const int stack = std::max(left.stack[k - 1], right.stack[slots - k - 1]);
        if (slots < 8) {
          EXPECT_EQ(forest.used[slots - 1], used);
          EXPECT_EQ(forest.stack[slots - 1], stack);
        } else {
          EXPECT_EQ(plan.stack(), bvh::stack_of_node(used, stack));
        }
      }
    }
  }
}

float cost_of(const Float8* boxes, std::size_t count, unsigned left_set) {
  Float8 sides[2] = {bvh::no_planes(), bvh::no_planes()};
  int held[2] = {0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const int side = (left_set >> i & 1u) != 0 ? 0 : 1;
    sides[side] = bvh::united<false>(sides[side], boxes[i]);
    ++held[side];
  }
  return bvh::half_area(sides[0]) * static_cast<float>(held[0]) +
         bvh::half_area(sides[1]) * static_cast<float>(held[1]);
}

TEST(BvhFew, ThreeAndFourArePartedInTheCheapestWay) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const auto items = primitives(4, seed);
    for (const std::size_t count : {3u, 4u}) {
      SCOPED_TRACE(testing::Message() << count << ", seed " << seed);
      Float8 boxes[4];
      for (std::size_t i = 0; i < count; ++i) boxes[i] = bvh::load_planes(items[i]);
      const bvh::Parting& parting =
          count == 3 ? bvh::part_three<false>(boxes[0], boxes[1], boxes[2])
                     : bvh::part_four<false>(boxes[0], boxes[1], boxes[2], boxes[3]);
      unsigned left_set = 0, all = 0;
      for (std::size_t i = 0; i < count; ++i) {
        all |= 1u << parting.order[i];
        if (i < parting.left_count) left_set |= 1u << parting.order[i];
      }
      EXPECT_EQ(all, (1u << count) - 1);
      float least = kInfinity;
      for (unsigned set = 1; set < all; ++set) least = std::min(least, cost_of(boxes, count, set));
      EXPECT_LE(cost_of(boxes, count, left_set), least * (1.0f + 1e-5f));
    }
  }
}

TEST(BvhRanks, CountWhatComesBefore) {
  std::mt19937 random(3);
  for (int n = 1; n <= 16; ++n) {
    bvh::Ranks<false, 16> ranks{};
    std::vector<int> order;
    for (int i = 0; i < n; ++i) {
      // The keys have few values, so that some are equal.
      ranks.key[i] = static_cast<float>(random() % 8);
      order.push_back(i);
    }
    ranks.count(n);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return ranks.key[a] < ranks.key[b]; });
    for (int i = 0; i < n; ++i) EXPECT_EQ(ranks.rank[order[static_cast<std::size_t>(i)]], i);
  }
}

}  // namespace
}  // namespace aerostat
