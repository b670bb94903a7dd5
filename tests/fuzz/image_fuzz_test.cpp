// Tests that the readers of pictures take any bytes. scripts/fuzz-inputs tests longer and with
// coverage.

#include <cstdint>
#include <cstdio>
#include <span>

#include <gtest/gtest.h>

#include "mutate.hpp"
#include "seeds.hpp"
#include "take_image.hpp"

namespace aerostat::test {
namespace {

constexpr int kTexts = 1500;

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

class ImageFuzz : public testing::TestWithParam<std::string> {};

TEST_P(ImageFuzz, AnyBytesAreReadOrRefusedInWords) {
  const std::vector<std::string> seeds = seeds_of("image/" + GetParam());
  bool is_read = false;
  for (const std::string& seed : seeds) {
    EXPECT_EQ(fault_of_image(GetParam(), bytes_of(seed), is_read), "");
    EXPECT_TRUE(is_read);
  }
  Mutator mutator(seeds, 1);
  int good = 0;
  for (int i = 0; i < kTexts; ++i) {
    const std::string text = mutator.next();
    ASSERT_EQ(fault_of_image(GetParam(), bytes_of(text), is_read), "") << "number " << i;
    good += is_read ? 1 : 0;
  }
  std::printf("%d files, %d of them read (seed 1)\n", kTexts, good);
  EXPECT_LT(good, kTexts) << "no file was damaged";
}

INSTANTIATE_TEST_SUITE_P(Readers, ImageFuzz, testing::ValuesIn(image_readers()),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace aerostat::test
