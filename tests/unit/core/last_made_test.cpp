// Tests the cache of one value.
#include "core/last_made.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace aerostat {
namespace {

using Cache = LastMade<int, std::string>;

std::shared_ptr<const std::string> text_of(int number) {
  return std::make_shared<const std::string>(std::to_string(number));
}

TEST(LastMade, MakesAValueOnceForEachKeyInTurn) {
  Cache cache;
  for (const int key : {7, 7, 8, 8, 7}) {
    EXPECT_EQ(*cache.get(key, [&] { return text_of(key); }), std::to_string(key));
  }
  EXPECT_EQ(cache.count(), 3);
}

TEST(LastMade, LeavesAValueToWhoHoldsIt) {
  Cache cache;
  const auto held = cache.get(7, [] { return text_of(7); });
  cache.get(8, [] { return text_of(8); });
  EXPECT_EQ(*held, "7");
}

TEST(LastMade, KeepsNothingOfAFailure) {
  Cache cache;
  cache.get(7, [] { return text_of(7); });
  const auto fail = []() -> std::shared_ptr<const std::string> { throw std::runtime_error("no"); };
  EXPECT_THROW(cache.get(8, fail), std::runtime_error);
  EXPECT_EQ(*cache.get(8, [] { return text_of(8); }), "8");
  EXPECT_EQ(*cache.get(7, [] { return text_of(7); }), "7");
  EXPECT_EQ(cache.count(), 3);
}

}  // namespace
}  // namespace aerostat
