// Tests that the reader of checkpoints takes any bytes. scripts/fuzz-inputs tests longer and with
// coverage.

#include <cstdio>

#include <gtest/gtest.h>

#include "mutate.hpp"
#include "take_checkpoint.hpp"

namespace aerostat::test {
namespace {

constexpr int kTexts = 20000;

std::string fault_of_text(const std::string& text, bool& is_read) {
  return fault_of_checkpoint({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                             is_read);
}

TEST(CheckpointFuzz, AnyBytesAreReadOrRefusedInWords) {
  const std::string seed = whole_checkpoint();
  bool is_read = false;
  EXPECT_EQ(fault_of_text(seed, is_read), "");
  EXPECT_TRUE(is_read);
  Mutator mutator({seed}, 1);
  int good = 0;
  for (int i = 0; i < kTexts; ++i) {
    const std::string text = mutator.next();
    ASSERT_EQ(fault_of_text(text, is_read), "") << "number " << i;
    good += is_read ? 1 : 0;
  }
  std::printf("%d texts, %d of them checkpoints (seed 1)\n", kTexts, good);
  EXPECT_GT(good, 0) << "the changes leave nothing to read";
  EXPECT_LT(good, kTexts) << "no text was damaged";
}

}  // namespace
}  // namespace aerostat::test
