#include "pack/texels.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace aerostat::pack {
namespace {

using Words = std::vector<std::uint32_t>;

TEST(Texels, LieOneBehindTheOther) {
  const auto a = std::make_shared<const Words>(Words{1, 2, 3});
  const auto none = std::make_shared<const Words>();
  const auto b = std::make_shared<const Words>(Words{4, 5});
  Texels texels;
  EXPECT_EQ(texels.add(a, *a), 0u);
  EXPECT_EQ(texels.add(none, *none), 3u);
  EXPECT_EQ(texels.add(b, *b), 3u);
  EXPECT_EQ(texels.size(), 5u);
  ASSERT_EQ(texels.parts().size(), 2u);
  EXPECT_EQ(texels.parts()[1].words.data(), b->data());
}

TEST(Texels, KeepTheirWords) {
  auto words = std::make_shared<const Words>(Words{1});
  const std::weak_ptr<const Words> alive = words;
  Texels texels;
  texels.add(words, *words);
  words = nullptr;
  EXPECT_FALSE(alive.expired());
}

TEST(Texels, AreTheSameIfTheirWordsAre) {
  const auto a = std::make_shared<const Words>(Words{1, 2});
  const auto alike = std::make_shared<const Words>(Words{1, 2});
  Texels one, other, third, longer;
  one.add(a, *a);
  other.add(a, *a);
  third.add(alike, *alike);
  longer.add(a, *a);
  longer.add(alike, *alike);
  EXPECT_TRUE(one == other);
  EXPECT_FALSE(one == third);
  EXPECT_FALSE(one == longer);
}

// The words are never read, so that the test needs no 16 GiB.
TEST(Texels, HavePlacesOf32Bits) {
  const std::uint32_t word = 0;
  Texels texels;
  texels.add(nullptr, std::span(&word, std::numeric_limits<std::uint32_t>::max() - 1u));
  EXPECT_EQ(texels.add(nullptr, std::span(&word, 1)),
            std::numeric_limits<std::uint32_t>::max() - 1u);
  try {
    texels.add(nullptr, std::span(&word, 1));
    FAIL() << "expected an error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::exhausted);
    EXPECT_NE(std::string(error.what()).find("texels"), std::string::npos);
  }
}

}  // namespace
}  // namespace aerostat::pack
