#include "image/deflate.hpp"

#include <cstdlib>
#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace aerostat::image {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes inflated(const Bytes& stream) {
  int length = 0;
  char* data = stbi_zlib_decode_malloc(reinterpret_cast<const char*>(stream.data()),
                                       static_cast<int>(stream.size()), &length);
  EXPECT_NE(data, nullptr);
  if (data == nullptr) return {};
  Bytes result(data, data + length);
  std::free(data);
  return result;
}

Bytes noise(std::size_t count, unsigned values) {
  std::mt19937 random(31);
  Bytes data(count);
  for (std::uint8_t& byte : data) byte = static_cast<std::uint8_t>(random() % values);
  return data;
}

TEST(Deflate, ReturnsWhatWentIn) {
  for (const std::size_t count : {0u, 1u, 3u, 4u, 5u, 1000u, 131071u, 131072u, 131073u, 700000u}) {
    for (const unsigned values : {1u, 2u, 4u, 256u}) {
      SCOPED_TRACE(testing::Message() << count << " bytes of " << values << " values");
      const Bytes data = noise(count, values);
      EXPECT_EQ(inflated(deflate(data)), data);
    }
  }
}

TEST(Deflate, MatchesOfEveryLengthAndDistanceSurvive) {
  Bytes data = noise(40000, 256);
  std::mt19937 random(32);
  for (std::size_t length = 4; length <= 270; ++length) {
    const std::size_t distance = 1 + random() % 33000;
    for (std::size_t k = 0; k < length; ++k) data.push_back(data[data.size() - distance]);
    data.push_back(static_cast<std::uint8_t>(random()));
  }
  EXPECT_EQ(inflated(deflate(data)), data);
}

TEST(Deflate, ShrinksWhatRepeatsAndHardlyGrowsNoise) {
  EXPECT_LT(deflate(Bytes(1000000, 7)).size(), 12000u);
  EXPECT_LT(deflate(noise(1000000, 256)).size(), 1001000u);
}

TEST(Deflate, KnowsTheSumOfRfc1950) {
  const Bytes stream = deflate(Bytes{'W', 'i', 'k', 'i', 'p', 'e', 'd', 'i', 'a'});
  EXPECT_EQ(Bytes(stream.end() - 4, stream.end()), (Bytes{0x11, 0xe6, 0x03, 0x98}));
}

/// The sums of the parts that threads compress are put together. stb does not look at the result.
TEST(Deflate, EndsWithTheSumOfAllParts) {
  const Bytes data = noise(300000, 256);
  std::uint32_t a = 1, b = 0;
  for (const std::uint8_t byte : data) {
    a = (a + byte) % 65521u;
    b = (b + a) % 65521u;
  }
  const std::uint32_t sum = b << 16 | a;
  const Bytes stream = deflate(data);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(stream[stream.size() - 4 + i], (sum >> (24 - 8 * i)) & 255u) << "byte " << i;
  }
}

TEST(Deflate, GivesTheSameBytesOnAnyNumberOfThreads) {
  const Bytes data = noise(1000000, 6);
  const Bytes first = deflate(data);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(deflate(data), first);
}

}  // namespace
}  // namespace aerostat::image
