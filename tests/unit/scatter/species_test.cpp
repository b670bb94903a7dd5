// Tests where plants of species from files grow, and how tall they are.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "mesh_over.hpp"
#include "scatter/scatter.hpp"
#include "scene/io.hpp"
#include "support/resolved.hpp"

namespace aerostat::scatter {
namespace {

using scene::BiomeKind;
using scene::PlantPlace;

/// The species of a scene on level land at 100 m that is all wooded or all open. Their models are 2
/// units high and 1 unit wide.
class Species : public testing::Test {
 protected:
  Species() {
    scene_.terrain.cells = 4;
    scene_.biome.ground.forest_share = 1.5;  // no clearings
    scene_.biome.ground.forest_top_m = 1e5;
    scene_.biome.water.enabled = false;
    scene_.vegetation.reach_m = 400.0;
    scene_.camera.position = {0.0, 500.0, 0.0};
    scene_.balloon.enabled = false;
  }

  scene::PlantSpecies& add(PlantPlace grows) {
    scene::PlantSpecies& species = scene_.vegetation.species.emplace_back();
    species.file = "tree.glb";
    species.grows = grows;
    return species;
  }

  Growth grown(const CoverLookup* cover = nullptr) const {
    const std::vector<SpeciesModel> models(scene_.vegetation.species.size(), {2.0, 1.0});
    return scatter(test::resolved(scene_),
                   mesh_over(64, 4000.0, [this](double x, double) { return 100.0 + rise_ * x; }),
                   Where::everywhere, {}, cover, models);
  }

  /// Returns the plants of a species.
  static std::vector<Instance> of(const Growth& growth, std::size_t species) {
    std::vector<Instance> found;
    for (const Instance& one : growth.instances) {
      if (one.model == growth.models.size() + species) found.push_back(one);
    }
    return found;
  }

  /// Returns the number of usual plants, without stones.
  static std::size_t usual(const Growth& growth) {
    return static_cast<std::size_t>(
        std::count_if(growth.instances.begin(), growth.instances.end(), [&](const Instance& one) {
          if (one.model >= growth.models.size()) return false;
          const plant::Species species = growth.models[one.model].species;
          return species != plant::Species::boulder && species != plant::Species::snowy_boulder;
        }));
  }

  scene::Scene scene_ = scene::defaults(BiomeKind::snow, scene::View::outside);
  double rise_ = 0.0;  // of the ground to the east
};

TEST_F(Species, TakeTheirShareOfTheWoods) {
  const auto before = static_cast<double>(usual(grown()));
  ASSERT_GT(before, 3000.0);
  add(PlantPlace::woods).share = 0.3;
  add(PlantPlace::woods).share = 0.1;
  const Growth mixed = grown();
  EXPECT_NEAR(static_cast<double>(of(mixed, 0).size()) / before, 0.3, 0.03);
  EXPECT_NEAR(static_cast<double>(of(mixed, 1).size()) / before, 0.1, 0.02);
  EXPECT_NEAR(static_cast<double>(usual(mixed)) / before, 0.6, 0.03);
  // Without the usual plants, the shares count in proportion.
  scene_.vegetation.usual = false;
  const Growth alone = grown();
  EXPECT_EQ(usual(alone), 0u);
  EXPECT_NEAR(static_cast<double>(of(alone, 0).size()) / before, 0.75, 0.04);
  EXPECT_NEAR(static_cast<double>(of(alone, 1).size()) / before, 0.25, 0.04);
  // Shares of more than all of the trees do, too.
  scene_.vegetation.usual = true;
  for (scene::PlantSpecies& one : scene_.vegetation.species) one.share = 1.0;
  const Growth full = grown();
  EXPECT_EQ(usual(full), 0u);
  EXPECT_NEAR(static_cast<double>(of(full, 0).size()) / before, 0.5, 0.04);
}

TEST_F(Species, LeaveTheUsualPlantsWhereTheyAreIfThereAreNone) {
  const Growth before = grown();
  add(PlantPlace::woods).share = 0.0;
  EXPECT_TRUE(of(grown(), 0).empty());
  scene_.vegetation.species.clear();
  const Growth after = grown();
  ASSERT_EQ(after.instances.size(), before.instances.size());
  for (std::size_t i = 0; i < after.instances.size(); ++i) {
    ASSERT_EQ(after.instances[i].position, before.instances[i].position);
    ASSERT_EQ(after.instances[i].tint, before.instances[i].tint);
  }
}

TEST_F(Species, HaveTheHeightsOfTheirRange) {
  scene::PlantSpecies& species = add(PlantPlace::woods);
  species.height_m = dvec2(8.0, 15.0);
  scene_.vegetation.size = 2.0;
  float least = 1e9f, most = 0.0f;
  for (const Instance& one : of(grown(), 0)) {
    least = std::min(least, 2.0f * one.scale);
    most = std::max(most, 2.0f * one.scale);
  }
  EXPECT_GE(least, 16.0f);
  EXPECT_LT(least, 18.0f);
  EXPECT_GT(most, 28.0f);
  EXPECT_LE(most, 30.0f);
  // The model of the file is 2 m high.
  species.height_m.reset();
  scene_.vegetation.size = 1.0;
  for (const Instance& one : of(grown(), 0)) EXPECT_EQ(one.scale, 1.0f);
}

TEST_F(Species, DifferInBrightnessByTheirTint) {
  scene::PlantSpecies& species = add(PlantPlace::woods);
  species.tint = 0.0;
  for (const Instance& one : of(grown(), 0)) EXPECT_EQ(one.tint, vec3(1.0f));
  species.tint = 0.2;
  float least = 1e9f, most = 0.0f;
  for (const Instance& one : of(grown(), 0)) {
    least = std::min(least, one.tint.y);
    most = std::max(most, one.tint.y);
  }
  EXPECT_GT(least, 0.7f);
  EXPECT_LT(least, 0.9f);
  EXPECT_GT(most, 1.1f);
  EXPECT_LT(most, 1.3f);
}

TEST_F(Species, GrowInTheOpenOrAnywhere) {
  scene_.vegetation.usual = false;
  add(PlantPlace::open).per_hectare = 50.0;
  add(PlantPlace::anywhere).per_hectare = 50.0;
  // A share of 1 within half of the reach, thinned out from there on: 7 twelfths of the circle.
  const double hectares = 3.14159265 * 400.0 * 400.0 / 1e4 * (7.0 / 12.0);
  const Growth wooded = grown();
  EXPECT_LT(static_cast<double>(of(wooded, 0).size()), 5.0 * hectares) << "woods are not open";
  EXPECT_NEAR(static_cast<double>(of(wooded, 1).size()) / hectares, 50.0, 5.0);
  scene_.biome.ground.forest_share = 0.0;
  const Growth open = grown();
  EXPECT_NEAR(static_cast<double>(of(open, 0).size()) / hectares, 50.0, 5.0);
  EXPECT_GT(open.instances.size(), of(open, 0).size() + of(open, 1).size()) << "stones stay";
  scene_.vegetation.density = 0.5;
  EXPECT_NEAR(static_cast<double>(of(grown(), 1).size()) / hectares, 25.0, 3.0);
  // The species have places of their own.
  EXPECT_NE(of(open, 0)[0].position, of(open, 1)[0].position);
}

TEST_F(Species, KeepToHeightsAndSlopes) {
  scene_.vegetation.usual = false;
  scene::PlantSpecies& low = add(PlantPlace::anywhere);
  low.heights_m = {90.0, 120.0};
  scene::PlantSpecies& steep = add(PlantPlace::anywhere);
  steep.slope_deg = {20.0, 40.0};
  scene::PlantSpecies& woods = add(PlantPlace::woods);
  woods.heights_m = {90.0, 120.0};
  rise_ = 0.25;  // 14 degrees
  const Growth gentle = grown();
  ASSERT_FALSE(of(gentle, 0).empty());
  ASSERT_FALSE(of(gentle, 2).empty());
  for (const std::size_t species : {std::size_t{0}, std::size_t{2}}) {
    for (const Instance& one : of(gentle, species)) {
      EXPECT_GE(one.position.y, 90.0f);
      EXPECT_LE(one.position.y, 120.0f);
    }
  }
  EXPECT_TRUE(of(gentle, 1).empty());
  rise_ = 0.5;  // 27 degrees
  EXPECT_FALSE(of(grown(), 1).empty());
}

TEST_F(Species, KeepToTheirLandCover) {
  const CoverLookup cover{[](double x, double) {
                            CoverShares shares{};
                            const auto is = x < 0.0 ? CoverClass::shrub : CoverClass::crops;
                            shares[static_cast<std::size_t>(is)] = 1.0f;
                            return shares;
                          },
                          10.0f};
  scene_.vegetation.usual = false;
  scene::PlantSpecies& species = add(PlantPlace::anywhere);
  species.cover = {CoverClass::meadow, CoverClass::shrub};
  const auto found = of(grown(&cover), 0);
  ASSERT_GT(found.size(), 100u);
  for (const Instance& one : found) EXPECT_LT(one.position.x, 0.0f);
  EXPECT_TRUE(of(grown(), 0).empty()) << "no land cover";
  species.cover = {CoverClass::water};
  EXPECT_TRUE(of(grown(&cover), 0).empty());
}

TEST_F(Species, ThatAreDenseEndNearer) {
  scene_.vegetation.usual = false;
  scene_.vegetation.reach_m = 2000.0;
  add(PlantPlace::anywhere).per_hectare = 10000.0;
  scene_.biome.ground.forest_share = 0.0;
  const auto found = of(grown(), 0);
  EXPECT_LT(found.size(), 1000000u);
  EXPECT_GT(found.size(), 400000u);
}

}  // namespace
}  // namespace aerostat::scatter
