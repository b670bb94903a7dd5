// Tests the further balloons of a world, their level of detail and their light.
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "pack/pack_balloon.hpp"
#include "pack/pack_geometry.hpp"
#include "pack/pack_scene.hpp"
#include "scene/io.hpp"
#include "scene/palettes.hpp"
#include "support/resolved.hpp"
#include "world/world.hpp"

namespace aerostat {
namespace {

scene::Scene small_world(const std::string& more) {
  return *world::resolve(scene::read_text(
      R"({"version": 1, "biome": "sand", "terrain": {"cells": 32}, "vegetation": {"enabled": false})" +
          more + "}",
      "x.json"));
}

const std::string kTwo =
    R"(, "balloons": [{"position": [300, 80, -900]}, {"position": [-200, 60, -500], "palette": "plum"}])";

const world::Objects& balloons_in(const world::World& world) {
  return *world::shape_of<world::Objects>(world, world::kBalloons);
}

std::uint64_t revision_of(const world::World& world, const world::GroupKind& kind) {
  for (const world::Group& group : world.groups) {
    if (group.kind == &kind) return group.revision;
  }
  return 0;
}

/// Whether a world of `next` keeps the group of a kind from the world before.
bool keeps(const world::GroupKind& kind, const scene::Scene& next, const world::World& before) {
  const world::World world = world::build(test::resolved(next), {.previous = &before});
  return revision_of(world, kind) == revision_of(before, kind);
}

TEST(Balloons, FurtherOnesStandAboveTheirOwnGround) {
  const scene::Scene scene = small_world(kTwo);
  ASSERT_EQ(scene.balloons.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(scene.balloons[i].height_above, scene::HeightReference::sea);
    EXPECT_NE(scene.balloons[i].position.y, i == 0 ? 80.0 : 60.0);
  }
  EXPECT_EQ(scene.balloons[1].colors, scene::palette_colors(scene::Palette::plum));
  EXPECT_NE(scene.balloons[0].colors, scene.balloons[1].colors);
}

TEST(Balloons, FarOnesTakeFewTriangles) {
  const scene::Scene one = small_world(""), three = small_world(kTwo);
  const auto triangles = [](const world::World& world) {
    std::size_t count = 0;
    for (const world::Object& object : balloons_in(world)) count += object.mesh.triangles.size();
    return count;
  };
  const world::World alone = world::build(test::resolved(one)),
                     together = world::build(test::resolved(three));
  EXPECT_EQ(balloons_in(together).size(), 3 * balloons_in(alone).size());
  EXPECT_LT(triangles(together), 2 * triangles(alone));
}

TEST(Balloons, AreKeptUntilOneOfThemChanges) {
  const scene::Scene first = small_world(kTwo);
  const world::World built = world::build(test::resolved(first));
  scene::Scene next = first;
  next.sun.irradiance = 3.0;
  EXPECT_TRUE(keeps(world::kBalloons, next, built));
  next.balloons[1].pattern = scene::Pattern::spiral;
  EXPECT_FALSE(keeps(world::kBalloons, next, built));
  next = first;
  *next.camera.position += 3.0 * (next.balloon.position - *next.camera.position) / 4.0;
  EXPECT_FALSE(keeps(world::kBalloons, next, built)) << "nearer, finer";
  next = first;
  next.balloon.enabled = false;
  for (scene::Balloon& balloon : next.balloons) balloon.enabled = false;
  EXPECT_TRUE(balloons_in(world::build(test::resolved(next), {.previous = &built})).empty());
}

TEST(World, PlantsFollowAFurtherBalloon) {
  scene::Scene first = small_world(kTwo);
  first.vegetation.enabled = true;
  first.vegetation.reach_m = 300.0;
  const world::World built = world::build(test::resolved(first));
  ASSERT_FALSE(world::shape_of<world::Instances>(built, world::kPlants)->places.empty());
  const auto keeps_plants = [&](const scene::Scene& scene) {
    return keeps(world::kPlants, scene, built);
  };
  scene::Scene next = first;
  next.balloons[1].pattern = scene::Pattern::spiral;
  EXPECT_TRUE(keeps_plants(next)) << "plants do not see colours";
  next.balloons[1].position.x += 5.0;
  EXPECT_TRUE(keeps_plants(next)) << "plants far below do not see where it drifts";
  next.balloons[1].position.y = 0.0;
  EXPECT_FALSE(keeps_plants(next)) << "plants leave room for a balloon on the ground";
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

/// The places of a scene's plants.
std::vector<dvec3> plants_of(const scene::Scene& scene) {
  const scene::ResolvedScene shown = test::resolved(scene);
  const world::World world = world::build(shown);
  std::vector<dvec3> plants;
  for (const auto& plant : world::shape_of<world::Instances>(world, world::kPlants)->places) {
    plants.push_back(dvec3(plant.position) + shown.origin());
  }
  return plants;
}

TEST(World, PlantsLeaveRoomForFurtherBalloons) {
  scene::Scene scene = small_world("");
  scene.vegetation.enabled = true;
  scene.vegetation.reach_m = 300.0;
  const std::vector<dvec3> grown = plants_of(scene);
  ASSERT_GT(grown.size(), 10u);
  scene.balloons.assign(2, scene.balloon);
  scene.balloons[0].position = grown.front();
  scene.balloons[1].position = grown.back();
  for (const dvec3& plant : plants_of(scene)) {
    for (const scene::Balloon& balloon : scene.balloons) {
      const dvec3 away = plant - balloon.position;
      EXPECT_GT(std::hypot(away.x, away.z), 0.6 * balloon.diameter_m);
    }
  }
}

TEST(BalloonLight, IsThatOfAnIntegratingSphere) {
  scene::Scene scene = small_world("");
  scene.balloon.colors = {vec3(0.5f)};
  auto& cloth = scene.material(scene::MaterialId::envelope);
  cloth.albedo = vec3(1.0f);
  cloth.diffuse = 0.8;
  cloth.translucency = 0.4;
  const AeroBalloon light = pack::pack_balloon(test::resolved(scene), scene.balloon);
  EXPECT_NEAR(light.glow_sky[1], 0.2 / (1.0 - 0.4), 1e-6);
  EXPECT_NEAR(light.glow_sun[1], 0.25 * 0.2 / (1.0 - 0.4), 1e-6);
  // If nothing is absorbed, all light that enters the envelope leaves it again.
  scene.balloon.colors = {vec3(1.0f)};
  cloth.diffuse = 0.6;
  EXPECT_NEAR(pack::pack_balloon(test::resolved(scene), scene.balloon).glow_sky[0], 1.0, 1e-6);
  scene.balloon.burner = 0.5;
  EXPECT_NEAR(pack::pack_balloon(test::resolved(scene), scene.balloon).flame_light[0],
              0.5 * 1.6 / std::numbers::pi, 1e-6);
}

/// Returns the numbers of the balloons that the faces of a group belong to.
std::set<std::uint32_t> balloons_of_faces(const world::Group& group) {
  std::set<std::uint32_t> numbers;
  for (const AeroFace& face : pack::pack_shape(*group.shape).arrays.faces) {
    numbers.insert(face.material >> AERO_FACE_BALLOON_SHIFT);
    EXPECT_LT(face.material & AERO_FACE_MATERIAL_MASK, unsigned{AERO_MAX_MATERIALS});
  }
  return numbers;
}

TEST(BalloonLight, IsThatOfEachBalloon) {
  scene::Scene scene = small_world("");
  scene.balloons.assign(2, scene.balloon);
  scene.balloon.enabled = false;
  scene.balloons[0].burner = 0.0;
  scene.balloons[1].position.x += 100.0;
  scene.balloons[1].burner = 1.0;
  const AeroScene packed = pack::pack_scene(test::resolved(scene)).numbers;
  ASSERT_EQ(packed.balloon_count, 2u) << "the first one is not there";
  EXPECT_EQ(packed.balloons[0].flame_light[0], 0.0f);
  EXPECT_GT(packed.balloons[1].flame_light[0], 0.0f);
  EXPECT_NEAR(packed.balloons[1].flame[0] - packed.balloons[0].flame[0], 100.0f, 1e-3f);
  const world::World world = world::build(test::resolved(scene));
  for (const world::Group& group : world.groups) {
    if (group.kind != &world::kBalloons) continue;
    EXPECT_EQ(balloons_of_faces(group), (std::set<std::uint32_t>{0, 1}));
  }
}

TEST(Burner, NoFireNoFlame) {
  const auto has_flame = [](const scene::Scene& scene) {
    const world::World world = world::build(test::resolved(scene));
    for (const world::Object& object : balloons_in(world)) {
      if (object.id == scene::ObjectId::flame) return true;
    }
    return false;
  };
  EXPECT_TRUE(has_flame(small_world(R"(, "balloon": {"burner": 0.1})")));
  EXPECT_FALSE(has_flame(small_world(R"(, "balloon": {"burner": 0})")));
}

}  // namespace
}  // namespace aerostat
