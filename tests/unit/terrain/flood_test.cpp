// Tests the order of a flood and the flow of water against the plainest algorithms.

#include "terrain/flood.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "terrain/receivers.hpp"

namespace aerostat::terrain {
namespace {

constexpr int kLast = std::numeric_limits<int>::max();

/// A rough ground of few heights, so that many of them are equal, with a rim above all.
struct Ground {
  RimmedGrid grid{61, 10.0f};
  Rimmed<float> heights;
  Rimmed<std::uint8_t> outlets;

  Ground(unsigned seed, unsigned levels) {
    heights.assign(grid.size(), std::numeric_limits<float>::infinity());
    outlets.assign(grid.size(), 0);
    std::mt19937 random(seed);
    for (int j = 0; j < grid.nodes; ++j)
      for (int i = 0; i < grid.nodes; ++i) {
        heights[grid.at(i, j)] = static_cast<float>(random() % levels) - 5.0f;
        outlets[grid.at(i, j)] = random() % 97 == 0 ? 1 : 0;
      }
  }
};

Rimmed<int> by_queue(const Ground& ground) {
  using Entry = std::pair<float, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  Rimmed<int> ranks(ground.grid.size(), kLast);
  std::vector<bool> seen(ground.grid.size(), false);
  for (std::size_t place = 0; place < seen.size(); ++place) {
    seen[place] = ground.outlets[place] != 0 || std::isinf(ground.heights[place]);
    if (ground.outlets[place] != 0) queue.emplace(ground.heights[place], place);
  }
  for (int reached = 0; !queue.empty(); ++reached) {
    const auto [level, node] = queue.top();
    queue.pop();
    ranks[node] = reached;
    for (int d = 0; d < 8; ++d) {
      const int other = node + ground.grid.step(d);
      if (seen[other]) continue;
      seen[other] = true;
      queue.emplace(std::max(level, ground.heights[other]), other);
    }
  }
  return ranks;
}

TEST(Flood, RisesAsAQueueByHeightSays) {
  for (const unsigned levels : {2u, 9u, 200u, 100000000u}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const Ground ground(seed, levels);
      ASSERT_EQ(flood_ranks(ground.grid, ground.heights, ground.outlets), by_queue(ground))
          << "seed " << seed << ", " << levels << " heights";
    }
  }
}

TEST(Receivers, LieBeforeTheirNodesAndLeadToAnOutlet) {
  const Ground ground(5, 300);
  const auto ranks = flood_ranks(ground.grid, ground.heights, ground.outlets);
  const auto directions = receivers_by_rank(ground.grid, ground.heights, ranks, ground.outlets, 77);
  for (int j = 0; j < ground.grid.nodes; ++j)
    for (int i = 0; i < ground.grid.nodes; ++i) {
      int place = ground.grid.at(i, j);
      while (directions[place] != kNoReceiver) {
        const int next = place + ground.grid.step(directions[place]);
        ASSERT_LT(ranks[next], ranks[place]);
        place = next;
      }
      ASSERT_EQ(ground.outlets[place], 1) << i << ", " << j;
    }
}

TEST(Receivers, ByHeightAreThoseByRankOfTheSortedHeights) {
  for (const unsigned levels : {5u, 1000u}) {
    const Ground ground(6, levels);
    std::vector<int> order;
    for (std::size_t place = 0; place < ground.heights.size(); ++place)
      if (!std::isinf(ground.heights[place])) order.push_back(static_cast<int>(place));
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return ground.heights[a] < ground.heights[b]; });
    Rimmed<int> ranks(ground.heights.size(), kLast);
    for (std::size_t k = 0; k < order.size(); ++k) ranks[order[k]] = static_cast<int>(k);
    EXPECT_EQ(receivers_by_height(ground.grid, ground.heights, ground.outlets, 78),
              receivers_by_rank(ground.grid, ground.heights, ranks, ground.outlets, 78));
  }
}

}  // namespace
}  // namespace aerostat::terrain
