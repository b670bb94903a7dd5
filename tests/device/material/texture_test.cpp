// Tests that kernels read textures as their files say.
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "pack/mip_levels.hpp"
#include "probe.hpp"

namespace aerostat::test {
namespace {

using pack::TexelKind;

constexpr std::uint32_t kFirst = 7;  // words of other pictures lie before the texture

/// A texture of 4 x 2 texels. Its red grows by 50 with each column, and its green by 100 with each
/// row.
asset::Texture steps() {
  asset::Texture texture{"steps", 4, 2, {}};
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 4; ++column) {
      for (const int byte : {50 * column, 100 * row, 255, 128 + column}) {
        texture.rgba.push_back(static_cast<std::uint8_t>(byte));
      }
    }
  }
  return texture;
}

class Textures : public LaneTest {
 protected:
  struct Seen {
    vec3 color;
    float opacity;
  };

  /// Returns what is seen at points: u, v and the footprint on a texture that is 1 m wide.
  std::vector<Seen> look(const asset::TextureUse& use, TexelKind kind,
                         const std::vector<vec3>& points) const {
    std::vector<std::uint32_t> texels(kFirst, 0x12345678u);
    const auto words = pack::texture_words(steps(), use, kind);
    texels.insert(texels.end(), words.begin(), words.end());
    const std::size_t count = whole_packets(points.size());
    const auto found = output<float>(4 * count);
    const std::uint32_t is_color = kind == TexelKind::data ? 0 : 1;
    Probe{"texture.cl", GetParam()}.run("probe_texture", count, input(texels),
                                        input(std::vector<std::uint32_t>{kFirst, is_color}),
                                        input(planes(points)), found);
    const auto read = found.read();
    std::vector<Seen> seen;
    for (std::size_t i = 0; i < points.size(); ++i) {
      seen.push_back({{read[i], read[count + i], read[2 * count + i]}, read[3 * count + i]});
    }
    return seen;
  }

  static float byte(float value) { return value / 255.0f; }
};

constexpr float kTiny = 1e-4f;

TEST_P(Textures, HaveTheirTexelsInTheMiddleOfEach) {
  const auto seen = look({}, TexelKind::data, {{0.125f, 0.25f, kTiny}, {0.875f, 0.75f, kTiny}});
  EXPECT_NEAR(seen[0].color.x, 0.0f, 1e-4f);
  EXPECT_NEAR(seen[0].color.y, 0.0f, 1e-4f);
  EXPECT_NEAR(seen[0].opacity, byte(128), 1e-4f);
  EXPECT_NEAR(seen[1].color.x, byte(150), 1e-4f);
  EXPECT_NEAR(seen[1].color.y, byte(100), 1e-4f);
  EXPECT_NEAR(seen[1].opacity, byte(131), 1e-4f);
}

TEST_P(Textures, AreMixedBetweenTexels) {
  const auto seen = look({}, TexelKind::data, {{0.25f, 0.5f, kTiny}, {0.3125f, 0.25f, kTiny}});
  EXPECT_NEAR(seen[0].color.x, byte(25), 1e-4f);
  EXPECT_NEAR(seen[0].color.y, byte(50), 1e-4f);
  EXPECT_NEAR(seen[1].color.x, byte(37.5f), 1e-4f);
}

TEST_P(Textures, NearestTexelsShowAsSquares) {
  asset::TextureUse use;
  use.nearest = true;
  const auto seen = look(use, TexelKind::data, {{0.24f, 0.49f, kTiny}, {0.26f, 0.51f, kTiny}});
  EXPECT_NEAR(seen[0].color.x, 0.0f, 1e-4f);
  EXPECT_NEAR(seen[1].color.x, byte(50), 1e-4f);
  EXPECT_NEAR(seen[1].color.y, byte(100), 1e-4f);
}

TEST_P(Textures, GoOnBeyondTheirEdges) {
  struct Case {
    asset::Wrap wrap;
    float beyond, before;  // the red at u = 1.125 and at u = -0.375
  };
  for (const Case& one :
       {Case{asset::Wrap::repeat, 0.0f, 100.0f}, Case{asset::Wrap::mirror, 150.0f, 50.0f},
        Case{asset::Wrap::clamp, 150.0f, 0.0f}}) {
    const auto seen = look({0, one.wrap, one.wrap, false}, TexelKind::data,
                           {{1.125f, 0.25f, kTiny}, {-0.375f, 0.25f, kTiny}});
    EXPECT_NEAR(seen[0].color.x, byte(one.beyond), 1e-4f) << static_cast<int>(one.wrap);
    EXPECT_NEAR(seen[1].color.x, byte(one.before), 1e-4f) << static_cast<int>(one.wrap);
  }
}

TEST_P(Textures, RepeatAcrossTheirEdge) {
  const auto seen = look({}, TexelKind::data, {{0.0f, 0.25f, kTiny}, {3.0f, 0.25f, kTiny}});
  EXPECT_NEAR(seen[0].color.x, byte(75), 1e-4f) << "the mean of the first and the last texel";
  EXPECT_NEAR(seen[1].color.x, byte(75), 1e-4f);
}

TEST_P(Textures, ColoursAreDecoded) {
  const auto seen = look({}, TexelKind::opaque_color, {{0.875f, 0.25f, kTiny}});
  EXPECT_NEAR(seen[0].color.x, std::pow((150.0f / 255.0f + 0.055f) / 1.055f, 2.4f), 1e-4f);
  EXPECT_NEAR(seen[0].color.z, 1.0f, 1e-5f);
  EXPECT_EQ(seen[0].opacity, 1.0f);
}

// A footprint as wide as the texture sees its mean. One of half of this size sees the level of
// 2 x 1 texels: the texels of the first level are 0.25 m x 0.5 m large.
TEST_P(Textures, AreFilteredByTheFootprint) {
  const auto seen = look({}, TexelKind::data, {{0.25f, 0.5f, 100.0f}, {0.25f, 0.5f, 0.7071f}});
  EXPECT_NEAR(seen[0].color.x, byte(75), 2e-3f);
  EXPECT_NEAR(seen[0].color.y, byte(50), 2e-3f);
  EXPECT_NEAR(seen[1].color.x, byte(25), 3e-3f);
}

AEROSTAT_AT_EVERY_WIDTH(Textures);

}  // namespace
}  // namespace aerostat::test
