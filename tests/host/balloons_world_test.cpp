// Tests the further balloons of a world, their level of detail and their light.
#include <numbers>

#include <gtest/gtest.h>

#include "pack/pack_balloon.hpp"
#include "scene/io.hpp"
#include "scene/palettes.hpp"
#include "world/world.hpp"

namespace aerostat {
namespace {

scene::Scene small_world(const std::string& more) {
  scene::Scene scene = scene::read_text(
      R"({"version": 1, "biome": "sand", "terrain": {"cells": 32}, "vegetation": {"enabled": false})" +
          more + "}",
      "x.json");
  world::resolve(scene);
  return scene;
}

const std::string kTwo =
    R"(, "balloons": [{"position": [300, 80, -900]}, {"position": [-200, 60, -500], "palette": "plum"}])";

TEST(Balloons, FurtherOnesStandAboveTheirOwnGround) {
  const scene::Scene scene = small_world(kTwo);
  ASSERT_EQ(scene.balloons.size(), 2u);
  const mesh::GridMesh& ground = *world::build(scene).land->ground;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(scene.balloons[i].height_above, scene::HeightReference::sea);
    EXPECT_NE(scene.balloons[i].position.y, i == 0 ? 80.0 : 60.0);
  }
  EXPECT_GT(ground.columns(), 0u);
  EXPECT_EQ(scene.balloons[1].colors, scene::palette_colors(scene::Palette::plum));
  EXPECT_NE(scene.balloons[0].colors, scene.balloons[1].colors);
}

TEST(Balloons, FarOnesTakeFewTriangles) {
  const scene::Scene one = small_world(""), three = small_world(kTwo);
  const auto triangles = [](const world::World& world) {
    std::size_t count = 0;
    for (const world::Object& object : *world.balloon) count += object.mesh.triangles.size();
    return count;
  };
  const world::World alone = world::build(one), together = world::build(three);
  EXPECT_EQ(together.balloon->size(), 3 * alone.balloon->size());
  EXPECT_LT(triangles(together), 2 * triangles(alone));
}

TEST(Balloons, AreKeptUntilOneOfThemChanges) {
  const scene::Scene first = small_world(kTwo);
  const world::World built = world::build(first);
  scene::Scene next = first;
  next.sun.irradiance = 3.0;
  EXPECT_EQ(world::build(next, &built, &first).balloon, built.balloon);
  next.balloons[1].pattern = scene::Pattern::spiral;
  EXPECT_NE(world::build(next, &built, &first).balloon, built.balloon);
  next = first;
  next.camera.position += 3.0 * (next.balloon.position - next.camera.position) / 4.0;
  EXPECT_NE(world::build(next, &built, &first).balloon, built.balloon) << "nearer, finer";
  next = first;
  next.balloon.enabled = false;
  for (scene::Balloon& balloon : next.balloons) balloon.enabled = false;
  EXPECT_EQ(world::build(next, &built, &first).balloon, nullptr);
}

TEST(World, PlantsFollowAFurtherBalloon) {
  scene::Scene first = small_world(kTwo);
  first.vegetation.enabled = true;
  first.vegetation.reach_m = 300.0;
  const world::World built = world::build(first);
  ASSERT_NE(built.plants, nullptr);
  const auto keeps_plants = [&](const scene::Scene& next) {
    return world::build(next, &built, &first).plants == built.plants;
  };
  scene::Scene next = first;
  next.balloons[1].pattern = scene::Pattern::spiral;
  EXPECT_TRUE(keeps_plants(next)) << "plants do not see colours";
  next.balloons[1].position.x += 5.0;
  EXPECT_FALSE(keeps_plants(next));
  next = first;
  next.balloons[0].enabled = false;
  EXPECT_FALSE(keeps_plants(next));
  next = first;
  next.balloons[0].diameter_m += 1.0;
  EXPECT_FALSE(keeps_plants(next));
  next = first;
  next.balloons.pop_back();
  EXPECT_FALSE(keeps_plants(next));
}

TEST(BalloonLight, IsThatOfAnIntegratingSphere) {
  scene::Scene scene = small_world("");
  scene.balloon.colors = {vec3(0.5f)};
  auto& cloth = scene.material(scene::MaterialId::envelope);
  cloth.albedo = vec3(1.0f);
  cloth.diffuse = 0.8;
  cloth.translucency = 0.4;
  const AeroBalloon light = pack::pack_balloon(scene);
  EXPECT_NEAR(light.glow_sky[1], 0.2 / (1.0 - 0.4), 1e-6);
  EXPECT_NEAR(light.glow_sun[1], 0.25 * 0.2 / (1.0 - 0.4), 1e-6);
  // If nothing is absorbed, all light that enters the envelope leaves it again.
  scene.balloon.colors = {vec3(1.0f)};
  cloth.diffuse = 0.6;
  EXPECT_NEAR(pack::pack_balloon(scene).glow_sky[0], 1.0, 1e-6);
  scene.balloon.burner = 0.5;
  EXPECT_NEAR(pack::pack_balloon(scene).flame_light[0], 0.5 * 1.6 / std::numbers::pi, 1e-6);
  scene.balloon.enabled = false;
  EXPECT_EQ(pack::pack_balloon(scene).glow_sky[0], 0.0f);
}

TEST(Burner, NoFireNoFlame) {
  const auto has_flame = [](const scene::Scene& scene) {
    for (const world::Object& object : *world::build(scene).balloon) {
      if (object.id == scene::ObjectId::flame) return true;
    }
    return false;
  };
  EXPECT_TRUE(has_flame(small_world(R"(, "balloon": {"burner": 0.1})")));
  EXPECT_FALSE(has_flame(small_world(R"(, "balloon": {"burner": 0})")));
}

}  // namespace
}  // namespace aerostat
