// Tests that the cheap tests of a candidate only reject what the full tests reject too.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "ground/ground_numbers.hpp"
#include "scatter/biome_layers.hpp"
#include "scene/io.hpp"
#include "support/resolved.hpp"
#include "terrain/terrain_mesh.hpp"

namespace aerostat::scatter {
namespace {

mesh::GridMesh small_land(const scene::Scene& scene) {
  scene::Terrain terrain = scene.terrain;
  terrain.cells = 96;
  return terrain::terrain_mesh(terrain);
}

class Bounds : public testing::TestWithParam<scene::BiomeKind> {};

TEST_P(Bounds, OfTheChanceHoldWhateverSlopeAndRoughNoiseAre) {
  const scene::Scene scene = scene::defaults(GetParam(), scene::View::outside);
  const mesh::GridMesh ground = small_land(scene);
  const Surface surface(ground);
  const ground::GroundRule rule(ground::ground_numbers(scene), 1.0f);
  const Nature nature{scene, surface, rule};
  std::mt19937 random(17);
  std::uniform_real_distribution<double> place(-4000.0, 4000.0);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  int bounded = 0, likely = 0;
  for (const Layer& layer : biome_layers(nature)) {
    if (!layer.chance_at_most) continue;
    ++bounded;
    for (int k = 0; k < 3000; ++k) {
      const SurfacePoint point = surface.at(place(random), place(random));
      Site site{
          point.position, point.normal, 0.0f, {any(random), any(random), any(random), {}, {}}};
      if (k % 3 == 0) site.position.y = 30.0f * any(random);
      site.above_sea = site.position.y - sea_level(nature);
      const float most = layer.chance_at_most(site);
      for (int turn = 0; turn < 4; ++turn) {
        site.noise.rough = 2.0f * any(random);
        site.normal = glm::normalize(vec3(any(random), 1.0f, any(random)));
        const float chance = layer.chance(site);
        EXPECT_LE(chance, most) << "layer " << layer.id;
        likely += chance > 0.1f ? 1 : 0;
      }
    }
  }
  EXPECT_GE(bounded, 2);
  EXPECT_GT(likely, 100) << "nothing was tested";
}

INSTANTIATE_TEST_SUITE_P(Every, Bounds,
                         testing::Values(scene::BiomeKind::snow, scene::BiomeKind::tropical,
                                         scene::BiomeKind::sand, scene::BiomeKind::meadow));

TEST(Lines, FindTheCellThatHoldsAValue) {
  std::mt19937 random(9);
  for (const std::size_t count : {2u, 3u, 10u, 1000u}) {
    SCOPED_TRACE(count);
    std::vector<float> values;
    // The cells have very different widths.
    std::uniform_real_distribution<float> width(-6.0f, 4.0f);
    for (float at = -500.0f; values.size() < count; at += std::exp2(width(random)))
      values.push_back(at);
    Lines lines;
    for (const float value : values) lines.add(value);
    lines.index();
    std::uniform_real_distribution<double> inside(values.front() - 1.0, values.back() + 1.0);
    for (int k = 0; k < 2000; ++k) {
      // Half of the values lie on lines, the others between them.
      const double value = k % 2 == 0 ? inside(random) : double{values[random() % count]};
      const auto next = std::upper_bound(values.begin() + 1, values.end() - 1, value);
      const Lines::Place place = lines.at(value);
      ASSERT_EQ(place.cell, next - values.begin() - 1) << value;
      const double from = values[place.cell], to = values[place.cell + 1];
      EXPECT_EQ(place.share,
                static_cast<float>(std::clamp((value - from) / (to - from), 0.0, 1.0)));
      EXPECT_EQ(lines.cover(value), value >= values.front() && value <= values.back());
    }
  }
}

TEST(Sight, SaysTheSameRowByRow) {
  const scene::Scene scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  const mesh::GridMesh ground = small_land(scene);
  const Sight sight(test::resolved(scene), ground, 3000.0, {10.0, 20.0});
  int matter = 0, do_not = 0;
  for (double z = -4000.0; z <= 4000.0; z += 97.0) {
    const Sight::Row row = sight.row(z);
    for (double x = -4000.0; x <= 4000.0; x += 41.0) {
      ASSERT_EQ(row.matters(x), sight.matters(x, z));
      ++(row.matters(x) ? matter : do_not);
    }
  }
  EXPECT_GT(matter, 100);
  EXPECT_GT(do_not, 100);
}

}  // namespace
}  // namespace aerostat::scatter
