// Tests marks in picture files, and that damage is noticed.
#include "image/mark.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "image/film.hpp"
#include "image/write.hpp"

namespace aerostat::image {
namespace {

std::vector<std::uint8_t> marked_png() {
  Pixels pixels{7, 5, std::vector<std::uint8_t>(105)};
  for (std::size_t i = 0; i < pixels.rgb.size(); ++i) {
    pixels.rgb[i] = static_cast<std::uint8_t>(37 * i);
  }
  auto png = encode_png(pixels);
  mark_png(png, "0.4 0123abcd");
  return png;
}

std::vector<std::uint8_t> marked_exr() {
  Film film;
  film.width = 40;
  film.height = 30;
  film.first = {3, 2};
  film.whole = {60, 50};
  film.radiance.resize(1200);
  film.object_id.resize(1200);
  for (std::size_t i = 0; i < 1200; ++i) {
    film.radiance[i] = vec3(static_cast<float>(i * i % 811));
    film.object_id[i] = static_cast<std::uint32_t>(i * 7919u);
  }
  return encode_exr(film, "0.4 0123abcd");
}

TEST(Mark, IsReadBack) {
  const MarkedFile png = mark_of_png(marked_png()), exr = mark_of_exr(marked_exr());
  EXPECT_TRUE(png.is_whole);
  EXPECT_EQ(png.mark, "0.4 0123abcd");
  EXPECT_TRUE(exr.is_whole);
  EXPECT_EQ(exr.mark, "0.4 0123abcd");
  const MarkedFile plain = mark_of_png(encode_png({1, 1, {1, 2, 3}}));
  EXPECT_TRUE(plain.is_whole);
  EXPECT_EQ(plain.mark, "");
}

TEST(Mark, AnyChangedOrMissingByteOfAPngIsNoticed) {
  const auto whole = marked_png();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    auto damaged = whole;
    damaged[i] ^= 0x10;
    EXPECT_FALSE(mark_of_png(damaged).is_whole) << i;
    EXPECT_FALSE(mark_of_png({whole.data(), i}).is_whole) << i;
  }
  auto longer = whole;
  longer.push_back(0);
  EXPECT_FALSE(mark_of_png(longer).is_whole);
}

TEST(Mark, AnExrThatIsCutOffOrDamagedIsNoticed) {
  const auto whole = marked_exr();
  for (std::size_t length = 0; length < whole.size(); length += 97) {
    EXPECT_FALSE(mark_of_exr({whole.data(), length}).is_whole) << length;
  }
  auto damaged = whole;
  for (std::size_t i = whole.size() - 400; i < whole.size() - 300; ++i) damaged[i] ^= 0xff;
  EXPECT_FALSE(mark_of_exr(damaged).is_whole);
}

}  // namespace
}  // namespace aerostat::image
