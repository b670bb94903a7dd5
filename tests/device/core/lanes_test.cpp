// Tests that the functions of lanes.clh have the same meaning at every width.
#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "probe.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kCount = 256;
const float kNaN = std::numeric_limits<float>::quiet_NaN();

class Lanes : public LaneTest {
 protected:
  const Probe probe{"lanes.cl", GetParam()};
  const std::size_t lanes = static_cast<std::size_t>(GetParam());
  std::mt19937 random{31};
};

std::vector<float> some_floats(std::mt19937& random, std::size_t count) {
  const float special[] = {0.0f, -0.0f, kInfinity, -kInfinity, 1e-38f, -1e38f};
  std::uniform_real_distribution<float> plain(-9.0f, 9.0f);
  std::vector<float> values(count);
  for (float& v : values) v = random() % 4 == 0 ? special[random() % 6] : plain(random);
  return values;
}

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

TEST_P(Lanes, CompareAndSelectLaneByLane) {
  auto a = some_floats(random, kCount), b = some_floats(random, kCount);
  for (std::size_t i = 0; i < kCount; i += 7) (i % 2 == 0 ? a : b)[i] = kNaN;
  for (std::size_t i = 3; i < kCount; i += 11) b[i] = a[i];
  const auto less = output<int>(kCount);
  const auto chosen = output<float>(kCount), least = output<float>(kCount);
  const auto most = output<float>(kCount);
  const auto chosen_uint = output<std::uint32_t>(kCount);
  probe.run("probe_compare", kCount, input(a), input(b), less, chosen, least, most, chosen_uint);
  const auto masks = less.read();
  const auto selected = chosen.read(), minima = least.read(), maxima = most.read();
  const auto words = chosen_uint.read();
  for (std::size_t i = 0; i < kCount; ++i) {
    const bool is_less = a[i] < b[i];
    ASSERT_EQ(masks[i], is_less ? -1 : 0) << i;
    ASSERT_TRUE(same_bits(selected[i], is_less ? a[i] : b[i])) << i;
    // As documented, the result is b if one of them is NaN.
    ASSERT_TRUE(same_bits(minima[i], is_less ? a[i] : b[i])) << i;
    ASSERT_TRUE(same_bits(maxima[i], a[i] > b[i] ? a[i] : b[i])) << i;
    ASSERT_EQ(words[i], is_less ? static_cast<std::uint32_t>(i % lanes) : 99u) << i;
  }
}

TEST_P(Lanes, GatherMasksIntoBits) {
  std::vector<int> masks(2 * kCount);
  for (std::size_t i = 0; i < kCount; ++i) masks[i] = random() % 2 == 0 ? -1 : 0;
  for (std::size_t i = kCount; i < kCount + 64; ++i) masks[i] = i < kCount + 32 ? -1 : 0;
  for (std::size_t i = kCount + 64; i < masks.size(); ++i) masks[i] = i % 17 == 3 ? -1 : 0;
  const std::size_t packets = masks.size() / lanes;
  const auto bits = output<std::uint32_t>(packets);
  const auto any_all = output<int>(2 * packets);
  probe.run("probe_bits", masks.size(), input(masks), bits, any_all);
  const auto words = bits.read();
  const auto flags = any_all.read();
  for (std::size_t p = 0; p < packets; ++p) {
    std::uint32_t expected = 0;
    for (std::size_t i = 0; i < lanes; ++i) expected |= (masks[p * lanes + i] & 1u) << i;
    ASSERT_EQ(words[p], expected) << p;
    ASSERT_EQ(flags[2 * p] != 0, expected != 0) << p;
    ASSERT_EQ(flags[2 * p + 1] != 0, expected == (1u << lanes) - 1u) << p;
  }
}

TEST_P(Lanes, GatherEightMasksOfANode) {
  std::vector<int> masks(8 * 256);
  for (std::size_t i = 0; i < masks.size(); ++i) masks[i] = (i / 8 >> i % 8 & 1) != 0 ? -1 : 0;
  const auto bits = output<std::uint32_t>(256);
  probe.run_items("probe_bits8", 256, input(masks), bits);
  const auto words = bits.read();
  for (std::uint32_t i = 0; i < 256; ++i) ASSERT_EQ(words[i], i);
}

TEST_P(Lanes, ReduceToTheSmallestAndTheLargest) {
  const auto a = some_floats(random, kCount);
  const std::size_t packets = kCount / lanes;
  const auto least = output<float>(packets), most = output<float>(packets);
  probe.run("probe_reduce", kCount, input(a), least, most);
  const auto minima = least.read(), maxima = most.read();
  for (std::size_t p = 0; p < packets; ++p) {
    const auto first = a.begin() + static_cast<std::ptrdiff_t>(p * lanes);
    const auto [lo, hi] = std::minmax_element(first, first + static_cast<std::ptrdiff_t>(lanes));
    ASSERT_EQ(minima[p], *lo) << p;
    ASSERT_EQ(maxima[p], *hi) << p;
  }
}

TEST_P(Lanes, GatherFromTables) {
  const auto numbers = some_floats(random, 1000);
  std::vector<std::uint32_t> words(1000), index(kCount);
  for (auto& w : words) w = static_cast<std::uint32_t>(random());
  for (auto& i : index) i = static_cast<std::uint32_t>(random() % 1000);
  const auto number = output<float>(kCount);
  const auto word = output<std::uint32_t>(kCount);
  probe.run("probe_gather", kCount, input(numbers), input(words), input(index), number, word);
  const auto got_numbers = number.read();
  const auto got_words = word.read();
  for (std::size_t i = 0; i < kCount; ++i) {
    ASSERT_TRUE(same_bits(got_numbers[i], numbers[index[i]])) << i;
    ASSERT_EQ(got_words[i], words[index[i]]) << i;
  }
}

TEST_P(Lanes, ConvertAndCount) {
  std::vector<float> numbers(kCount);
  std::uniform_real_distribution<float> plain(-1e6f, 1e6f);
  for (float& v : numbers) v = plain(random);
  const auto ints = output<int>(kCount);
  const auto bits = output<std::uint32_t>(kCount), index = output<std::uint32_t>(kCount);
  const auto back = output<float>(kCount), array = output<float>(kCount);
  probe.run("probe_convert", kCount, input(numbers), ints, bits, back, index, array);
  const auto whole = ints.read();
  const auto words = bits.read(), lane = index.read();
  const auto sums = back.read();
  EXPECT_EQ(array.read(), numbers);
  for (std::size_t i = 0; i < kCount; ++i) {
    const float truncated = std::trunc(numbers[i]);
    ASSERT_EQ(whole[i], static_cast<int>(truncated));
    ASSERT_EQ(words[i], std::bit_cast<std::uint32_t>(numbers[i]));
    ASSERT_EQ(sums[i], truncated + std::abs(truncated) + 0.25f);
    ASSERT_EQ(lane[i], i % lanes);
  }
}

// Tests differences of products whose products round to the same number. A fused difference would
// leave their rounding, but the triangle test must see zero there.
TEST_P(Lanes, DifferencesOfProductsAreNotFused) {
  std::uniform_real_distribution<float> plain(-100.0f, 100.0f);
  std::vector<float> a(kCount), b(kCount), c(kCount), d(kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    a[i] = plain(random);
    b[i] = plain(random);
    c[i] = i % 2 == 0 ? b[i] : plain(random);
    d[i] = i % 2 == 0 ? a[i] : plain(random);
  }
  const auto difference = output<float>(kCount);
  probe.run("probe_difference", kCount, input(a), input(b), input(c), input(d), difference);
  const auto values = difference.read();
  for (std::size_t i = 0; i < kCount; ++i) {
    const volatile float p = a[i] * b[i], q = c[i] * d[i];
    ASSERT_EQ(values[i], p - q) << i;
  }
}

AEROSTAT_AT_EVERY_WIDTH(Lanes);

}  // namespace
}  // namespace aerostat::test
