// Tests that the rules of the ground say what their words say: snow lies high and not on cliffs,
// and woods keep off rock, shores and heights.
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "ground/ground_numbers.hpp"
#include "ground/ground_rule.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::ground {
namespace {

constexpr GroundNoise kEven{};

class GroundMix : public testing::Test {
 protected:
  GroundMix() {
    scene::Scene scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
    scene::Ground& ground = scene.biome.ground;
    ground.snow_line_m = 1000.0;
    ground.snow_fuzz_m = 200.0;
    ground.beach_top_m = 3.0;
    ground.forest_share = 1.0;
    ground.forest_top_m = 900.0;
    numbers_ = ground_numbers(scene);
  }

  /// Returns the mix at a height and a slope, both of the mesh and in detail, without noise.
  rules::GroundMix at(float height, float slope_deg) const {
    const float cosine = std::cos(radians_from_degrees(slope_deg));
    return rules::ground_mix(&numbers_, height, cosine, cosine, &kEven);
  }

  AeroGround numbers_;
};

TEST_F(GroundMix, SnowLiesAboveItsLineAndNotOnCliffs) {
  EXPECT_EQ(at(1200.0f, 10.0f).snow, 1.0f);
  EXPECT_EQ(at(800.0f, 10.0f).snow, 0.0f) << "below the line";
  EXPECT_EQ(at(1200.0f, 70.0f).snow, 0.0f) << "a cliff";
}

TEST_F(GroundMix, LandCoverSaysWhatGrowsAtAnyHeight) {
  const auto forest_on = [this](CoverClass is, float height) {
    GroundNoise noise{};
    CoverShares shares{};
    shares[static_cast<std::size_t>(is)] = 1.0f;
    rules::note_cover(shares.data(), &noise);
    return rules::ground_mix(&numbers_, height, 1.0f, 1.0f, &noise);
  };
  EXPECT_EQ(forest_on(CoverClass::woods, 300.0f).forest, 1.0f);
  EXPECT_EQ(forest_on(CoverClass::woods, 950.0f).forest, 1.0f) << "above the upper limit";
  EXPECT_EQ(forest_on(CoverClass::meadow, 300.0f).forest, 0.0f);
  EXPECT_EQ(forest_on(CoverClass::crops, 300.0f).forest, 0.0f);
  EXPECT_EQ(forest_on(CoverClass::snow, 300.0f).snow, 1.0f);
  EXPECT_GT(forest_on(CoverClass::bare, 300.0f).rock, 0.7f);
  // Without trees in the biome, known woods are the only ones.
  numbers_.forest_share = 0.0f;
  numbers_.has_cover = 1u;
  EXPECT_EQ(forest_on(CoverClass::woods, 300.0f).forest, 1.0f);
  EXPECT_EQ(at(300.0f, 10.0f).forest, 0.0f);
}

TEST_F(GroundMix, RockIsWhatIsSteep) {
  EXPECT_EQ(at(400.0f, 10.0f).rock, 0.0f);
  EXPECT_EQ(at(400.0f, 60.0f).rock, 1.0f);
}

TEST_F(GroundMix, WoodsKeepOffRockShoresAndHeights) {
  EXPECT_EQ(at(300.0f, 10.0f).forest, 1.0f);
  EXPECT_EQ(at(300.0f, 65.0f).forest, 0.0f) << "a cliff";
  EXPECT_EQ(at(1.0f, 10.0f).forest, 0.0f) << "the beach";
  EXPECT_EQ(at(1000.0f, 10.0f).forest, 0.0f) << "above the upper limit";
}

TEST_F(GroundMix, ShoresAreSandOrWhereSteepRock) {
  EXPECT_EQ(at(1.0f, 5.0f).beach, 1.0f);
  EXPECT_EQ(at(1.0f, 5.0f).rock, 0.0f);
  EXPECT_EQ(at(1.0f, 30.0f).beach, 0.0f);
  EXPECT_EQ(at(1.0f, 30.0f).rock, 1.0f);
  EXPECT_EQ(at(30.0f, 5.0f).beach, 0.0f) << "above the shore";
}

}  // namespace
}  // namespace aerostat::ground
