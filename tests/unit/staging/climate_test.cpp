#include "staging/climate.hpp"

#include <gtest/gtest.h>

namespace aerostat::staging {
namespace {

using scene::BiomeKind;

TEST(Climate, DavosInOctoberHasFreshSnowAboveTheTrees) {
  const Climate climate = climate_of({46.8, 9.84}, 10.5, 556, 3373);
  EXPECT_EQ(climate.biome, BiomeKind::snow);
  EXPECT_NEAR(climate.tree_line_m, 2050, 150);
  EXPECT_GT(climate.snow_line_m, 2000);
  EXPECT_LT(climate.snow_line_m, 2700);
}

TEST(Climate, TheCanariesInMayHaveNoSnow) {
  const Climate climate = climate_of({28.27, -16.64}, 5.5, 0, 3715);
  EXPECT_GT(climate.snow_line_m, 3715);
}

TEST(Climate, AconcaguaInJanuaryIsWhiteHighUp) {
  const Climate climate = climate_of({-32.65, -70.01}, 1.5, 2500, 6961);
  EXPECT_EQ(climate.biome, BiomeKind::snow);
  EXPECT_GT(climate.snow_line_m, 4000);
  EXPECT_LT(climate.snow_line_m, 5500);
}

TEST(Climate, SeasonsAreTurnedOnTheOtherHemisphere) {
  EXPECT_EQ(climate_of({48, 2}, 4.5, 0, 200).season, scene::Season::spring);
  EXPECT_EQ(climate_of({-38, 145}, 4.5, 0, 200).season, scene::Season::autumn);
  EXPECT_LT(climate_of({46, 8}, 1.5, 400, 3000).snow_line_m,
            climate_of({46, 8}, 7.5, 400, 3000).snow_line_m - 1500);
  EXPECT_LT(climate_of({-44, 170}, 7.5, 400, 3000).snow_line_m,
            climate_of({-44, 170}, 1.5, 400, 3000).snow_line_m - 1500);
}

TEST(Climate, DesertsAreSandAndTheTropicsAreNot) {
  EXPECT_EQ(climate_of({36.1, -112.1}, 9.0, 700, 2500).biome, BiomeKind::sand);
  EXPECT_EQ(climate_of({24.0, 5.0}, 9.0, 500, 1500).biome, BiomeKind::sand);
  EXPECT_EQ(climate_of({-13.2, -72.5}, 9.0, 1800, 3000).biome, BiomeKind::tropical);
  EXPECT_EQ(climate_of({45.0, 5.0}, 9.0, 300, 900).biome, BiomeKind::meadow);
}

}  // namespace
}  // namespace aerostat::staging
