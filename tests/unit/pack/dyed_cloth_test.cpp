// Tests the texture of an envelope with pictures, which is exported.
#include "pack/dyed_cloth.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "artwork/unrolled.hpp"
#include "image/write.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::pack {
namespace {

/// A scene with one balloon of two colours, on which a green picture lies as a motif.
class DyedCloth : public testing::Test {
 protected:
  DyedCloth() {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < 16 * 16; ++i) rgba.insert(rgba.end(), {0, 255, 0, 255});
    const std::vector<std::uint8_t> png = image::encode_png(rgba, 16, 16);
    const auto file = folder_.path() / "green.png";
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    scene_.balloon.colors = {vec3(1.0f, 0.0f, 0.0f), vec3(0.0f, 0.0f, 1.0f)};
    scene_.balloon.pattern = scene::Pattern::checker;
    scene::Artwork& motif = scene_.balloon.artwork.emplace_back();
    motif.file = file.string();
    motif.wrap = scene::ArtworkWrap::motif;
    motif.around_deg = 90.0;
    motif.width_m = 6.0;
  }

  /// Returns the texel at a place that counts gores around and panels up.
  static glm::ivec3 texel(const asset::Texture& cloth, double gores, double panels,
                          const artwork::Unrolled& unrolled) {
    const auto x = static_cast<std::size_t>(gores / unrolled.gores() * cloth.width);
    const auto y =
        static_cast<std::size_t>((1.0 - panels / (unrolled.panels() + 1)) * cloth.height);
    const std::uint8_t* at = &cloth.rgba.at(4 * (y * cloth.width + x));
    return {at[0], at[1], at[2]};
  }

  test::TemporaryFolder folder_;
  scene::Scene scene_ = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
};

TEST_F(DyedCloth, HasThePicturesOverTheFabric) {
  const auto cloths = dyed_cloths(scene_);
  ASSERT_EQ(cloths.size(), 1u);
  ASSERT_EQ(cloths[0].width, kClothWidth);
  ASSERT_EQ(cloths[0].height, kClothHeight);
  const artwork::Unrolled unrolled(scene_.balloon);
  const double middle = unrolled.place_of(90.0);
  const double widest = unrolled.widest_height() / unrolled.panel_height();
  EXPECT_EQ(texel(cloths[0], middle, widest, unrolled), glm::ivec3(0, 255, 0));
  // The motif is 6 m wide and high.
  const double gores = 3.0 / unrolled.widest_gore(), panels = 3.0 / unrolled.panel_height();
  for (const double side : {-1.0, 1.0}) {
    EXPECT_EQ(texel(cloths[0], middle + 0.97 * side * gores, widest, unrolled).y, 255);
    EXPECT_EQ(texel(cloths[0], middle + 1.03 * side * gores, widest, unrolled).y, 0);
    EXPECT_EQ(texel(cloths[0], middle, widest + 0.97 * side * panels, unrolled).y, 255);
    EXPECT_EQ(texel(cloths[0], middle, widest + 1.03 * side * panels, unrolled).y, 0);
  }
  // The checks are those of the fabric, two gores wide and two panels high.
  const glm::ivec3 here = texel(cloths[0], 1.0, 4.5, unrolled);
  const glm::ivec3 beside = texel(cloths[0], 3.0, 4.5, unrolled);
  EXPECT_GT(std::abs(here.x - beside.x), 200);
  // Panels of one colour differ a little, as lots of cloth do.
  const glm::ivec3 other = texel(cloths[0], 3.0, 6.5, unrolled);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(here[i], other[i], 8);
  EXPECT_EQ(std::min(here.x, here.z), 0);
  EXPECT_GT(std::max(here.x, here.z), 240);
}

TEST_F(DyedCloth, IsThereForEachBalloonThatIs) {
  scene_.balloons.resize(2, scene_.balloon);
  scene_.balloons[0].enabled = false;
  scene_.balloons[1].artwork.clear();
  const auto cloths = dyed_cloths(scene_);
  ASSERT_EQ(cloths.size(), 2u);
  EXPECT_GT(cloths[0].width, 0u);
  EXPECT_EQ(cloths[1].width, 0u);
}

TEST_F(DyedCloth, NamesThePictureThatIsMissing) {
  scene_.balloon.artwork[0].file = "nowhere.png";
  try {
    dyed_cloths(scene_);
    FAIL() << "there is no such file";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("/balloon/artwork/0"), std::string::npos);
  }
}

}  // namespace
}  // namespace aerostat::pack
