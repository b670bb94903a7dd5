// Tests the light that a layer of clouds leaves to the land below.
#include "air/cloud_deck.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "air/light.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "support/resolved.hpp"

namespace aerostat::air {
namespace {

constexpr double kPi64 = std::numbers::pi;

// The light that comes down through the clouds is a geometric series: the ground sends a share
// back, of which the clouds send a share back again.
TEST(CloudDeck, SendsLightToAndFroBetweenCloudsAndGround) {
  const CloudDeck deck{0.7, 12.0, 1000.0, 1500.0};
  const double albedo = 0.6, through = deck.transmittance();
  EXPECT_DOUBLE_EQ(through, 1.0 / (1.0 + 0.75 * 0.13 * 12.0));
  double sum = 0.0, arriving = 1.0 - 0.7 + 0.7 * through;
  for (int i = 0; i < 200; ++i) {
    sum += arriving;
    arriving *= albedo * 0.7 * (1.0 - through);
  }
  EXPECT_NEAR(deck.light_below(dvec3(albedo)).y, sum, 1e-12);
}

TEST(CloudDeck, HidesMoreOfTheSkyTowardsTheHorizon) {
  const CloudDeck deck{0.3, 12.0, 1000.0, 1500.0};
  EXPECT_NEAR(deck.hidden(1.0), 0.3, 1e-12);
  EXPECT_NEAR(deck.hidden(std::sqrt(0.5)), 1.0 - 0.7 * 0.7, 1e-12);
  EXPECT_GT(deck.hidden(0.2), deck.hidden(0.6));
  EXPECT_EQ((CloudDeck{1.0, 12.0, 0.0, 1.0}.hidden(0.9)), 1.0);
  EXPECT_EQ((CloudDeck{}.hidden(0.1)), 0.0);
}

scene::ResolvedScene land_below(double cover, double eye_m) {
  auto scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  scene.camera.position = {0.0, eye_m, 0.0};
  scene.camera.height_above = scene::HeightReference::sea;
  scene.sky.cumulus.cover = cover;
  const double up = 40.0 * kPi64 / 180.0;
  scene.sun.direction = {std::cos(up), std::sin(up), 0.0};
  return test::resolved(scene);
}

double level_ambient(const Light& light) {
  const auto& c = light.ambient;
  return kPi64 * (c[0] + c[1] - c[6] - c[8]).y;
}

// Level ground below a closed deck has the share of the light that the layer lets through, and no
// more of it comes as the cover grows.
TEST(CloudDeck, DimsTheLandAsItCloses) {
  double before = 1e9;
  for (const double cover : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const scene::ResolvedScene scene = land_below(cover, 400.0);
    const Light light(scene);
    const CloudDeck deck = cloud_deck_of(*scene);
    const double direct = Scattering(light.atmosphere, scene->sun.direction)
                              .sunlight(deck.base, scene->sun.direction.y)
                              .y *
                          scene->sun.direction.y;
    const double level = direct + light.sky.irradiance_from_above().y;
    const double now = level_ambient(light) + direct * deck.sun_below(scene->sun.direction.y);
    EXPECT_LT(now, before) << cover;
    before = now;
    if (cover < 1.0) continue;
    const double expected = level * deck.light_below(light.atmosphere.ground_albedo).y;
    EXPECT_NEAR(now, expected, 0.06 * expected) << "the harmonics' error";
    EXPECT_LT(now, 0.75 * level);
  }
}

TEST(CloudDeck, LightsWhatIsAboveItFromBelow) {
  const Light clear(land_below(0.0, 6000.0)), closed(land_below(1.0, 6000.0));
  const auto down = [](const Light& light) {
    const auto& c = light.ambient;
    return (c[0] - c[1] - c[6] - c[8]).y;
  };
  EXPECT_NEAR(level_ambient(closed), level_ambient(clear), 0.1 * level_ambient(clear));
  EXPECT_GT(down(closed), 0.0);
  EXPECT_EQ(closed.deck_base, 2900.0);
  EXPECT_LT(closed.deck_sun, 0.1);
  EXPECT_EQ(clear.deck_sun, 1.0);
}

}  // namespace
}  // namespace aerostat::air
