// Tests that the readers of models take any bytes. scripts/fuzz-models tests longer and with
// coverage.

#include <cstdio>

#include <gtest/gtest.h>

#include "mutate.hpp"
#include "seeds.hpp"
#include "take_model.hpp"

namespace aerostat::test {
namespace {

constexpr int kTexts = 3000;

class ModelFuzz : public testing::TestWithParam<std::string> {};

TEST_P(ModelFuzz, AnyBytesAreReadOrRefusedInWords) {
  const std::vector<std::string> seeds = seeds_of(GetParam());
  bool is_read = false;
  for (const std::string& seed : seeds) {
    EXPECT_EQ(fault_of_model(GetParam(), seed, is_read), "");
    EXPECT_TRUE(is_read) << seed.substr(0, 200);
  }
  Mutator mutator(seeds, 1);
  int good = 0;
  for (int i = 0; i < kTexts; ++i) {
    const std::string text = mutator.next();
    ASSERT_EQ(fault_of_model(GetParam(), text, is_read), "") << "number " << i << "\n"
                                                             << text.substr(0, 2000);
    good += is_read ? 1 : 0;
  }
  std::printf("%d texts, %d of them models (seed 1)\n", kTexts, good);
  EXPECT_GT(good, kTexts / 200) << "the changes leave too little to read";
  EXPECT_LT(good, kTexts) << "no text was damaged";
}

INSTANTIATE_TEST_SUITE_P(Readers, ModelFuzz, testing::ValuesIn(model_readers()),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace aerostat::test
