// Tests the levels of detail of textures.
#include "pack/mip_levels.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "texture.h"

namespace aerostat::pack {
namespace {

asset::Texture texture_of(std::uint32_t width, std::uint32_t height,
                          const std::vector<std::uint32_t>& words) {
  asset::Texture texture{"a.png", width, height, {}};
  for (const std::uint32_t word : words) {
    for (int byte = 0; byte < 4; ++byte) {
      texture.rgba.push_back(static_cast<std::uint8_t>(word >> (8 * byte) & 255u));
    }
  }
  return texture;
}

constexpr std::uint32_t kWhite = 0xFFFFFFFFu, kBlack = 0xFF000000u, kClearRed = 0x000000FFu;

/// Returns the texel of the last level.
std::uint32_t mean_of(const asset::Texture& texture, TexelKind kind) {
  return texture_words(texture, {}, kind).back();
}

TEST(MipLevels, HaveAHeaderAndEachLevelHalfAsLarge) {
  const auto words =
      texture_words(texture_of(5, 2, std::vector<std::uint32_t>(10, kWhite)),
                    {0, asset::Wrap::clamp, asset::Wrap::mirror, true}, TexelKind::color);
  EXPECT_EQ(words[AERO_TEXTURE_WIDTH], 5u);
  EXPECT_EQ(words[AERO_TEXTURE_HEIGHT], 2u);
  EXPECT_EQ(words[AERO_TEXTURE_WRAP], AERO_WRAP_CLAMP | AERO_WRAP_MIRROR << 8 | 1u << 16);
  EXPECT_EQ(words[AERO_TEXTURE_LEVELS], 3u);
  EXPECT_EQ(words[AERO_TEXTURE_PLACES], 20u);
  EXPECT_EQ(words[AERO_TEXTURE_PLACES + 1], 30u);
  EXPECT_EQ(words[AERO_TEXTURE_PLACES + 2], 32u);
  ASSERT_EQ(words.size(), 33u);
  for (std::size_t i = AERO_TEXTURE_HEADER; i < words.size(); ++i) EXPECT_EQ(words[i], kWhite);
}

TEST(MipLevels, ColoursAreMeansOfLight) {
  const asset::Texture half = texture_of(2, 1, {kWhite, kBlack});
  // Half of the light of white is 188 of 255 in sRGB, and half of its number is 128.
  EXPECT_EQ(mean_of(half, TexelKind::color) & 255u, 188u);
  EXPECT_EQ(mean_of(half, TexelKind::data) & 255u, 128u);
}

TEST(MipLevels, WhatIsTransparentHasNoColour) {
  const asset::Texture leaf = texture_of(2, 1, {kWhite, kClearRed});
  EXPECT_EQ(mean_of(leaf, TexelKind::color), 0x80FFFFFFu);
  EXPECT_EQ(texture_words(leaf, {}, TexelKind::color)[AERO_TEXTURE_HEADER + 1], kClearRed);
  EXPECT_EQ(mean_of(leaf, TexelKind::opaque_color) >> 24, 255u);
  EXPECT_EQ(mean_of(leaf, TexelKind::opaque_color) >> 8 & 255u, 188u);
}

TEST(MipLevels, OddSidesAreMeansByArea) {
  // The level after three texels has one.
  const asset::Texture three = texture_of(1, 3, {0xFF0000FFu, 0xFF000000u, 0xFF000000u});
  EXPECT_EQ(mean_of(three, TexelKind::data) & 255u, 85u);
}

TEST(MipLevels, ATextureWithoutPixelsIsAnError) {
  try {
    texture_words({"a.png", 0, 4, {}}, {}, TexelKind::color);
    FAIL() << "expected an error";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "a.png: found a texture of 0 x 4 pixels, expected 1 to 32768 a side");
  }
}

}  // namespace
}  // namespace aerostat::pack
