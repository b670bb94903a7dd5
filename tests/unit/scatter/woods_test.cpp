// Tests that woods are as dense as painted ones, and that their trees keep apart and have snow.
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "ground/ground_numbers.hpp"
#include "ground/ground_rule.hpp"
#include "mesh_over.hpp"
#include "scatter/scatter.hpp"
#include "scene/io.hpp"
#include "support/resolved.hpp"

namespace aerostat::scatter {
namespace {

using plant::Species;
using scene::BiomeKind;

TEST(Woods, AreAsDenseAsThePaintedOnes) {
  scene::Scene scene = scene::defaults(BiomeKind::snow, scene::View::outside);
  scene.terrain.cells = 4;
  scene.biome.ground.forest_share = 1.0;
  scene.biome.ground.forest_top_m = 1e5;
  scene.vegetation.reach_m = 1200.0;
  scene.camera.position = {0.0, 500.0, 0.0};
  scene.balloon.enabled = false;
  const mesh::GridMesh ground = mesh_over(4, 4000.0, [](double, double) { return 100.0; });
  const ground::GroundRule rule(ground::ground_numbers(scene), 1.0f);
  // The share of woods within half the reach is averaged. A canopy's square holds one tree.
  double share = 0.0;
  std::vector<vec3> places;
  for (int i = 0; i < 20000; ++i) {
    const float r = 600.0f * std::sqrt(static_cast<float>(i) / 20000.0f);
    const float around = 2.399963f * static_cast<float>(i);
    places.emplace_back(r * std::cos(around), 100.0f, r * std::sin(around));
  }
  const auto noise = rule.noise(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    share += static_cast<double>(rule.forest(places[i], 1.0f, noise[i])) / 20000.0;
  }
  EXPECT_GT(share, 0.5);
  const double expected = share * 3.14159265 * 600.0 * 600.0 / (6.0 * 6.0);
  int found = 0;
  for (const Instance& instance : scatter(test::resolved(scene), ground).instances) {
    found += glm::length(vec2(instance.position.x, instance.position.z)) < 600.0f ? 1 : 0;
  }
  EXPECT_NEAR(found / expected, 1.0, 0.1);
}

/// Returns the plants of level land at 100 m that is all wooded, and their models.
Growth woods_everywhere(double snow_line_m) {
  scene::Scene scene = scene::defaults(BiomeKind::snow, scene::View::outside);
  scene.terrain.cells = 4;
  scene.biome.ground.forest_share = 1.5;  // no clearings
  scene.biome.ground.forest_top_m = 1e5;
  scene.biome.ground.snow_line_m = snow_line_m;
  scene.vegetation.reach_m = 400.0;
  scene.camera.position = {0.0, 500.0, 0.0};
  scene.balloon.enabled = false;
  return scatter(test::resolved(scene), mesh_over(4, 4000.0, [](double, double) { return 100.0; }));
}

// A tree stands in the middle nine tenths of a square of its own, 6 m wide.
TEST(Woods, GiveEachTreeASquareOfItsOwn) {
  const Growth growth = woods_everywhere(-1000.0);
  std::set<std::pair<int, int>> taken;
  for (const Instance& instance : growth.instances) {
    if (growth.models[instance.model].species == Species::boulder ||
        growth.models[instance.model].species == Species::snowy_boulder) {
      continue;
    }
    const float x = instance.position.x / 6.0f, z = instance.position.z / 6.0f;
    const std::pair square(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(z)));
    EXPECT_TRUE(taken.insert(square).second) << square.first << ", " << square.second;
  }
  EXPECT_GT(taken.size(), 5000u);
}

TEST(Woods, HaveSnowWhereTheGroundHas) {
  const auto snowy_share = [](const Growth& growth) {
    double snowy = 0.0, trees = 0.0;
    for (const Instance& instance : growth.instances) {
      const Species species = growth.models[instance.model].species;
      snowy += species == Species::snowy_spruce ? 1.0 : 0.0;
      trees += species == Species::snowy_spruce || species == Species::spruce ? 1.0 : 0.0;
    }
    return snowy / trees;
  };
  EXPECT_EQ(snowy_share(woods_everywhere(5000.0)), 0.0);
  const double below_the_line = snowy_share(woods_everywhere(-1000.0));
  EXPECT_GT(below_the_line, 0.3);
  EXPECT_LT(below_the_line, 0.6) << "low down, less than half of the trees are laden";
}

}  // namespace
}  // namespace aerostat::scatter
