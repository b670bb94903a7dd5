// Tests the orders in which a tree is traversed. A wrong order makes a picture slower but does not
// change it, so tests of pictures do not notice it.
#include <algorithm>
#include <random>

#include "bvh_node.h"
#include "probe.hpp"

namespace aerostat::test {
namespace {

class Order : public LaneTest {
 protected:
  const Probe probe{"stack.cl", GetParam()};
};

TEST_P(Order, TheNearestChildComesOnTopAndOlderEntriesStay) {
  constexpr std::size_t kItems = 256, kEntries = AERO_BVH_WIDTH + 1;
  std::mt19937 random(11);
  std::uniform_real_distribution<float> distance(0.0f, 100.0f);
  std::vector<float> enters(kItems * AERO_BVH_WIDTH);
  for (float& enter : enters) enter = distance(random);
  const auto references = output<std::uint32_t>(kItems * kEntries);
  probe.run_items("probe_push", kItems, input(enters), references);
  const auto stacks = references.read();
  for (std::size_t item = 0; item < kItems; ++item) {
    const std::uint32_t* stack = &stacks[item * kEntries];
    ASSERT_EQ(stack[0], 0u) << "the older entry";
    const auto enter = [&](std::size_t i) { return enters[item * AERO_BVH_WIDTH + stack[i] - 1]; };
    for (std::size_t i = 2; i < kEntries; ++i) ASSERT_LE(enter(i), enter(i - 1)) << item;
  }
}

// No cell of a patch comes before one that lies in front of it for all rays: nearer along one axis
// and not farther along the other.
TEST_P(Order, CellsOfAPatchAreTakenFromFrontToBack) {
  constexpr std::size_t kItems = 8;
  const auto columns = output<std::uint32_t>(kItems * AERO_BVH_WIDTH);
  const auto rows = output<std::uint32_t>(kItems * AERO_BVH_WIDTH);
  probe.run_items("probe_order", kItems, columns, rows);
  const auto x = columns.read(), z = rows.read();
  for (std::size_t item = 0; item < kItems; ++item) {
    const auto depth = [&](const std::vector<std::uint32_t>& along, std::size_t turn, bool down) {
      const int place = static_cast<int>(along[item * AERO_BVH_WIDTH + turn]);
      return down ? -place : place;
    };
    const bool down_x = (item & 1) != 0, down_z = (item & 2) != 0;
    for (std::size_t later = 1; later < AERO_BVH_WIDTH; ++later) {
      for (std::size_t turn = 0; turn < later; ++turn) {
        EXPECT_FALSE(depth(x, later, down_x) <= depth(x, turn, down_x) &&
                     depth(z, later, down_z) <= depth(z, turn, down_z))
            << "rays and shape " << item << ", turns " << turn << " and " << later;
      }
    }
  }
}

TEST_P(Order, BitsAreFlippedAsTheirNumbersAre) {
  constexpr std::size_t kItems = 8 * 256;
  const auto flipped = output<std::uint32_t>(kItems);
  probe.run_items("probe_flip", kItems, flipped);
  const auto bits = flipped.read();
  for (std::uint32_t item = 0; item < kItems; ++item) {
    const std::uint32_t flip = item >> 8;
    std::uint32_t expected = 0;
    for (std::uint32_t i = 0; i < 8; ++i) expected |= ((item >> (i ^ flip)) & 1u) << i;
    ASSERT_EQ(bits[item], expected) << item;
  }
}

AEROSTAT_AT_EVERY_WIDTH(Order);

}  // namespace
}  // namespace aerostat::test
