// Tests how the samples of a pixel are shared among moments.
#include "render/moments.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace aerostat::render {
namespace {

TEST(Moments, EachHasItsTurnOnce) {
  for (int moments = 1; moments <= 64; ++moments) {
    const std::vector<int> order = visits_of(moments);
    const std::set<int> different(order.begin(), order.end());
    ASSERT_EQ(order.size(), static_cast<std::size_t>(moments));
    EXPECT_EQ(different.size(), order.size());
    EXPECT_EQ(*different.begin(), 0);
    EXPECT_EQ(*different.rbegin(), moments - 1);
    EXPECT_EQ(order.front(), 0);
  }
}

TEST(Moments, FirstVisitsAreSpreadOverAll) {
  // Of the first n visits, no two are nearer to each other than half of an even spacing.
  for (const int moments : {8, 16, 64}) {
    const std::vector<int> order = visits_of(moments);
    for (int n = 2; n <= moments; ++n) {
      std::vector<int> first(order.begin(), order.begin() + n);
      std::sort(first.begin(), first.end());
      for (int i = 1; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        EXPECT_GE(2 * n * (first[at] - first[at - 1]), moments) << n << " of " << moments;
      }
    }
  }
}

TEST(Moments, SamplesAreSharedEvenly) {
  EXPECT_EQ(visit_ends(8, 8, false), (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(visit_ends(10, 4, false), (std::vector<int>{2, 5, 7, 10}));
  EXPECT_EQ(visit_ends(5, 1, false), (std::vector<int>{5}));
  for (int samples = 2; samples <= 70; ++samples) {
    for (int moments = 2; moments <= samples; ++moments) {
      const std::vector<int> ends = visit_ends(samples, moments, false);
      ASSERT_EQ(ends.size(), static_cast<std::size_t>(moments));
      EXPECT_EQ(ends.back(), samples);
      int before = 0;
      for (const int end : ends) {
        EXPECT_GE(end - before, samples / moments);
        EXPECT_LE(end - before, samples / moments + 1);
        before = end;
      }
    }
  }
}

TEST(Moments, DecisionsKnowAllOfThem) {
  // Pixels are tested after each 16 samples.
  for (const int moments : {2, 5, 8, 16}) {
    const std::vector<int> order = visits_of(moments);
    const std::vector<int> ends = visit_ends(64, moments, true);
    EXPECT_EQ(ends.back(), 64);
    std::set<int> seen;
    for (std::size_t visit = 0; visit < ends.size() && ends[visit] <= 16; ++visit) {
      seen.insert(order[visit % order.size()]);
    }
    EXPECT_EQ(seen.size(), order.size()) << moments;
  }
  EXPECT_EQ(visit_ends(20, 64, true).size(), 20u);
}

}  // namespace
}  // namespace aerostat::render
