// Tests where pictures lie on the cloth, and the mean colour of an envelope with them.
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "artwork/unrolled.hpp"
#include "asset/model.hpp"
#include "image/write.hpp"
#include "pack/artwork_layers.hpp"
#include "pack/mip_levels.hpp"
#include "pack/pack_artwork.hpp"
#include "scene/balloon.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::pack {
namespace {

using scene::ArtworkWrap;

const scene::Balloon kBalloon;

scene::Artwork artwork_of(ArtworkWrap wrap) {
  scene::Artwork artwork;
  artwork.wrap = wrap;
  return artwork;
}

TEST(ArtworkLayers, LieWhereTheSceneSays) {
  const artwork::Unrolled cloth(kBalloon);
  const ArtworkLayer whole = artwork_layer(artwork_of(ArtworkWrap::whole), cloth, 10, 10);
  EXPECT_EQ(whole.period, kBalloon.gores);
  EXPECT_EQ(whole.from, 0.0);
  EXPECT_EQ(whole.to, cloth.height());
  EXPECT_EQ(whole.width, 0.0);

  scene::Artwork motif = artwork_of(ArtworkWrap::motif);
  motif.width_m = 4.0;
  motif.height_m = 10.0;
  motif.repeat = 3;
  const ArtworkLayer placed = artwork_layer(motif, cloth, 200, 100);
  EXPECT_EQ(placed.width, 4.0);
  EXPECT_DOUBLE_EQ(placed.from, 9.0);
  EXPECT_DOUBLE_EQ(placed.to, 11.0);
  EXPECT_EQ(placed.period, kBalloon.gores / 3.0);

  // A square picture in a band of 4 m is repeated as often as 4 m fit around.
  scene::Artwork band = artwork_of(ArtworkWrap::band);
  const double middle = cloth.widest_height();
  band.heights_m = dvec2(middle - 2.0, middle + 2.0);
  const ArtworkLayer around = artwork_layer(band, cloth, 64, 64);
  EXPECT_DOUBLE_EQ(around.period, kBalloon.gores / 15.0) << "59 m over 4 m";
  band.repeat = 2;
  EXPECT_EQ(artwork_layer(band, cloth, 64, 64).period, kBalloon.gores / 2.0);
}

/// Returns the thumbnail of a picture of one colour.
Thumbnail plain(std::uint8_t red, std::uint8_t opacity) {
  asset::Texture texture{"plain", 256, 128, {}};
  for (int i = 0; i < 256 * 128; ++i) {
    texture.rgba.insert(texture.rgba.end(), {red, 0, 0, opacity});
  }
  const std::vector<std::uint32_t> words = texture_words(texture, {}, TexelKind::color);
  return thumbnail_of({words, 256, 128});
}

TEST(ArtworkMean, IsByAreaAndOpacity) {
  const artwork::Unrolled cloth(kBalloon);
  const dvec3 base(0.2, 0.4, 0.6);
  const ArtworkLayer whole = artwork_layer(artwork_of(ArtworkWrap::whole), cloth, 256, 128);
  const auto mean = [&](const ArtworkLayer& layer, const Thumbnail& picture) {
    return mean_with_artwork(cloth, base, {layer}, {picture});
  };
  const dvec3 red = mean(whole, plain(255, 255));
  EXPECT_NEAR(red.x, 1.0, 1e-6);
  EXPECT_NEAR(red.z, 0.0, 1e-6);
  const dvec3 half = mean(whole, plain(255, 128));
  EXPECT_NEAR(half.x, 128.0 / 255.0 + 0.2 * 127.0 / 255.0, 1e-5);
  EXPECT_NEAR(half.z, 0.6 * 127.0 / 255.0, 1e-5);
  // A motif of 8 m x 4 m on cloth of some 1,050 square metres.
  scene::Artwork motif = artwork_of(ArtworkWrap::motif);
  motif.width_m = 8.0;
  const ArtworkLayer placed = artwork_layer(motif, cloth, 256, 128);
  double area = 0.0;
  for (int i = 0; i < 1000; ++i) {
    area += cloth.height() / 1000.0 * cloth.gores() *
            cloth.gore_width((i + 0.5) * cloth.height() / 1000.0);
  }
  EXPECT_NEAR(mean(placed, plain(255, 255)).z, 0.6 * (1.0 - 32.0 / area), 2e-3);
}

/// Returns the mean opacity of a picture that is drawn on the template of 8 gores, with nothing
/// between them.
double mean_opacity(ArtworkWrap wrap) {
  scene::Balloon balloon;
  balloon.gores = 8;
  const artwork::Unrolled cloth(balloon);
  constexpr int kGore = 64, kWidth = 8 * kGore, kHeight = 128;
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < kHeight; ++y) {
    const double height = (1.0 - (y + 0.5) / kHeight) * cloth.height();
    const double half = 0.5 * cloth.gore_width(height) / cloth.widest_gore();
    for (int x = 0; x < kWidth; ++x) {
      const bool is_cloth = std::abs((x % kGore + 0.5) / kGore - 0.5) < half;
      rgba.insert(rgba.end(), {255, 0, 0, static_cast<std::uint8_t>(is_cloth ? 255 : 0)});
    }
  }
  const test::TemporaryFolder folder;
  const std::vector<std::uint8_t> png = image::encode_png(rgba, kWidth, kHeight);
  scene::Artwork artwork = artwork_of(wrap);
  artwork.file = (folder.path() / "gores.png").string();
  std::ofstream(artwork.file, std::ios::binary) << std::string(png.begin(), png.end());
  ArtworkCache cache;
  const Thumbnail picture = thumbnail_of(*artwork_texture(artwork, balloon, cache, "/artwork/0"));
  double sum = 0.0;
  for (const glm::vec4& texel : picture.texels) sum += static_cast<double>(texel.w);
  return sum / static_cast<double>(picture.texels.size());
}

TEST(ArtworkOfGores, FillsTheCloth) {
  EXPECT_LT(mean_opacity(ArtworkWrap::whole), 0.85) << "the gaps of the template";
  EXPECT_GT(mean_opacity(ArtworkWrap::gores), 0.98);
}

}  // namespace
}  // namespace aerostat::pack
