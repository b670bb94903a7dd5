// Tests densities, phase functions and paths of the air whose values are known in closed form.

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "air/sun_paths.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::air {
namespace {

constexpr double kPi64 = std::numbers::pi;

Atmosphere morning_air() {
  return atmosphere_of(scene::defaults(scene::BiomeKind::snow, scene::View::outside));
}

/// Returns the integral of a phase function over the sphere, by the midpoint rule over the cosine.
template <typename Phase>
double over_the_sphere(const Phase& phase) {
  const int steps = 20000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) sum += phase(-1.0 + (2.0 * i + 1.0) / steps);
  return sum * 2.0 / steps * 2.0 * kPi64;
}

TEST(Phase, GivesAwayAllOfTheLight) {
  EXPECT_NEAR(over_the_sphere(rayleigh_phase), 1.0, 1e-6);
  for (const double g : {0.0, 0.3, 0.76, 0.9}) {
    EXPECT_NEAR(over_the_sphere([g](double c) { return haze_phase(c, g); }), 1.0, 1e-4) << g;
  }
}

TEST(Phase, OfMoleculesIsThatOfTheSmallestDroplets) {
  for (double c = -1.0; c <= 1.0; c += 0.1) {
    EXPECT_NEAR(haze_phase(c, 0.0), rayleigh_phase(c), 1e-12);
  }
}

TEST(RayleighDepth, HasThePublishedValues) {
  // The values are from Bodhaine et al. 1999, table 3, for 1013.25 mbar.
  EXPECT_NEAR(rayleigh_depth(0.55), 0.09714, 2e-4);
  EXPECT_NEAR(rayleigh_depth(0.40), 0.36022, 1e-3);
}

TEST(Visibility, IsTheExtinctionAtTheSea) {
  auto scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  scene.haze.visibility_m = 40000.0;
  const Atmosphere air = atmosphere_of(scene);
  EXPECT_NEAR(air.extinction(air.density(0.0)).y, 3.912 / 40000.0, 1e-12);
  scene.haze.visibility_m = 1e7;
  EXPECT_EQ(atmosphere_of(scene).haze_extinction, dvec3(0.0)) << "molecules alone are more";
}

TEST(MeanDensity, IsTheIntegralOfTheDensity) {
  Atmosphere air = morning_air();
  air.fog = {0.01, 300.0, 40.0};
  for (const auto& [from, to] :
       {std::pair{0.0, 1.0}, {100.0, 700.0}, {900.0, 150.0}, {299.0, 301.0}, {0.0, 9000.0}}) {
    Density sum;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i) {
      const Density here = air.density(from + (to - from) * (i + 0.5) / steps);
      sum.molecules += here.molecules / steps;
      sum.haze += here.haze / steps;
      sum.fog += here.fog / steps;
    }
    const Density mean = air.mean_density(from, to);
    EXPECT_NEAR(mean.molecules, sum.molecules, 1e-7 * sum.molecules);
    EXPECT_NEAR(mean.haze, sum.haze, 1e-6 * sum.haze);
    EXPECT_NEAR(mean.fog, sum.fog, 1e-6 * sum.fog);
  }
}

TEST(Ways, MeetSpheresWhereGeometrySays) {
  EXPECT_DOUBLE_EQ(distance_to_height(500.0, 1.0, 2000.0), 1500.0);
  EXPECT_DOUBLE_EQ(distance_to_height(500.0, -1.0, 0.0), 500.0);
  EXPECT_DOUBLE_EQ(distance_to_height(0.0, -0.5, 0.0), 0.0);
  EXPECT_TRUE(std::isinf(distance_to_height(500.0, 0.0, 0.0)));
  for (const double cosine : {-0.2, -0.02, 0.0, 0.3}) {
    const double way = distance_to_height(1500.0, cosine, 30000.0);
    EXPECT_NEAR(height_after(1500.0, cosine, way), 30000.0, 1e-6);
  }
}

TEST(SunPaths, GoStraightUpThroughOneAir) {
  const Atmosphere air = morning_air();
  const SunPaths paths(air);
  const Columns up = paths.columns(0.0, 1.0);
  EXPECT_NEAR(air.molecules.y * up.molecules, rayleigh_depth(0.55), 2e-4);
  EXPECT_NEAR(up.haze, air.haze_height, 0.002 * air.haze_height);
  EXPECT_NEAR(up.ozone, 15000.0, 45.0);
  const dvec3 depth =
      air.molecules * up.molecules + air.haze_extinction * up.haze + air.ozone * up.ozone;
  EXPECT_LT(glm::distance(paths.transmittance(0.0, 1.0), glm::exp(-depth)), 1e-12);
}

TEST(SunPaths, AgreeWithFineQuadrature) {
  const Atmosphere air = morning_air();
  const SunPaths paths(air);
  for (const double height : {0.0, 700.0, 3300.0, 12000.0}) {
    for (const double elevation_deg : {1.0, 4.0, 15.0, 50.0}) {
      const double cosine = std::sin(elevation_deg * kPi64 / 180.0);
      const double length = distance_to_height(height, cosine, kTopHeight);
      const int steps = 100000;
      double molecules = 0.0, haze = 0.0;
      for (int i = 0; i < steps; ++i) {
        const Density here = air.density(height_after(height, cosine, length * (i + 0.5) / steps));
        molecules += here.molecules * length / steps;
        haze += here.haze * length / steps;
      }
      const Columns way = paths.columns(height, cosine);
      EXPECT_NEAR(way.molecules, molecules, 0.01 * molecules) << height << ", " << elevation_deg;
      EXPECT_NEAR(way.haze, haze, 0.03 * haze + 0.5) << height << ", " << elevation_deg;
    }
  }
}

TEST(SunPaths, ReddenTheLowSun) {
  const SunPaths paths(morning_air());
  double before = 1.0;
  for (const double elevation_deg : {90.0, 30.0, 10.0, 5.0, 2.0, 0.5}) {
    const dvec3 light = paths.transmittance(0.0, std::sin(elevation_deg * kPi64 / 180.0));
    EXPECT_LT(light.z / light.x, before) << elevation_deg;
    before = light.z / light.x;
  }
  EXPECT_LT(before, 0.05);
}

TEST(SunShare, GoesFromNoneToAllOverTheDisc) {
  EXPECT_EQ(sun_share(0.0, std::sin(0.27 * kPi64 / 180.0)), 1.0);
  EXPECT_NEAR(sun_share(0.0, 0.0), 0.5, 1e-12);
  EXPECT_EQ(sun_share(0.0, -std::sin(0.27 * kPi64 / 180.0)), 0.0);
  // From a height of 3000 m the horizon lies 1.76 degrees below the level.
  EXPECT_EQ(sun_share(3000.0, -std::sin(1.4 * kPi64 / 180.0)), 1.0);
  EXPECT_EQ(sun_share(3000.0, -std::sin(2.1 * kPi64 / 180.0)), 0.0);
}

TEST(FogLight, IsAllAboveAndLessTheDeeper) {
  const FogLayer fog{0.008, 300.0, 20.0};
  EXPECT_EQ(fog_light({}, 0.0, 0.3), 1.0);
  EXPECT_NEAR(fog_light(fog, 600.0, 0.3), 1.0, 1e-5);
  // At a depth of 200 m, tau = 0.008 * 200 / 0.3.
  EXPECT_NEAR(fog_light(fog, 100.0, 0.3), 1.0 / (1.0 + 0.15 * 0.008 * 200.0 / 0.3), 1e-5);
}

}  // namespace
}  // namespace aerostat::air
