#include "image/decode.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace aerostat::image {
namespace {

std::vector<std::uint8_t> seed(const std::string& name) {
  std::ifstream file(std::filesystem::path(AEROSTAT_SOURCE_DIR "/tests/fuzz/seeds/picture") / name,
                     std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string complaint(const std::vector<std::uint8_t>& bytes) {
  try {
    decode_8_bits(bytes, Channels::rgba, "JPEG", "x.jpg");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Returns the pixel in the middle.
template <class Sample>
std::vector<int> middle(const DecodedImage<Sample>& image) {
  const std::size_t at =
      static_cast<std::size_t>((image.height / 2) * image.width + image.width / 2) *
      static_cast<std::size_t>(image.channels);
  std::vector<int> pixel;
  for (int k = 0; k < image.channels; ++k) {
    pixel.push_back(static_cast<int>(image.samples.get()[at + static_cast<std::size_t>(k)]));
  }
  return pixel;
}

void expect_near(const std::vector<int>& pixel, const std::vector<int>& wanted) {
  ASSERT_EQ(pixel.size(), wanted.size());
  for (std::size_t k = 0; k < pixel.size(); ++k) EXPECT_NEAR(pixel[k], wanted[k], 4) << k;
}

TEST(Decode, JpegColoursAreRightWhateverTheFileStores) {
  for (const char* name : {"inks.jpg", "progressive.jpg"}) {
    const auto bytes = seed(name);
    expect_near(middle(decode_8_bits(bytes, Channels::rgba, "JPEG", name)), {200, 40, 90, 255});
    expect_near(middle(decode_8_bits(bytes, Channels::own, "JPEG", name)), {200, 40, 90});
  }
  const auto grey = seed("grey.jpg");
  expect_near(middle(decode_8_bits(grey, Channels::own, "JPEG", "x")), {94});
  expect_near(middle(decode_8_bits(grey, Channels::rgba, "JPEG", "x")), {94, 94, 94, 255});
}

TEST(Decode, PngHasItsOwnChannelsOrFour) {
  const auto alpha = decode_8_bits(seed("alpha.png"), Channels::own, "PNG", "x");
  EXPECT_EQ(alpha.channels, 4);
  EXPECT_EQ(alpha.width, 24);
  EXPECT_EQ(alpha.height, 16);
  const auto rgb = seed("rgb.png");
  EXPECT_EQ(middle(decode_8_bits(rgb, Channels::own, "PNG", "x")), (std::vector{120, 128, 99}));
  EXPECT_EQ(middle(decode_8_bits(rgb, Channels::rgba, "PNG", "x")),
            (std::vector{120, 128, 99, 255}));
  EXPECT_EQ(middle(decode_16_bits(rgb, "PNG", "x")), (std::vector{120 * 257, 128 * 257, 99 * 257}));
  EXPECT_EQ(middle(decode_8_bits(seed("palette.png"), Channels::own, "PNG", "x")).size(), 3u);
  EXPECT_EQ(image_size(rgb, "PNG", "x").width, 24);
}

TEST(Decode, DamagedFilesAreRefusedInWords) {
  EXPECT_NE(complaint(seed("huffman.jpg")).find("x.jpg: the JPEG file cannot be decoded: "),
            std::string::npos);
  auto cut = seed("rgb.png");
  cut.resize(cut.size() / 2);
  EXPECT_NE(complaint(cut).find("cannot be decoded: "), std::string::npos);
  auto short_jpeg = seed("rgb.jpg");
  short_jpeg.resize(short_jpeg.size() - 20);
  EXPECT_NE(complaint(short_jpeg), "");
  EXPECT_NE(complaint({0x89, 'P', 'N', 'G'}), "");
  EXPECT_NE(complaint({}), "");
  EXPECT_THROW(image_size({}, "JPEG", "x"), Error);
}

}  // namespace
}  // namespace aerostat::image
