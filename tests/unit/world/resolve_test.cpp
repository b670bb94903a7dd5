// Tests what resolving a scene fills in, and what becomes of resolved scenes.
#include "world/resolve.hpp"

#include <cmath>
#include <cstdlib>
#include <stop_token>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/stop_scope.hpp"
#include "scene/io.hpp"
#include "scene/local_frame.hpp"
#include "support/error_of.hpp"
#include "support/resolved.hpp"

namespace aerostat {
namespace {

using scene::HeightReference;

scene::Scene small_land(const std::string& more = "") {
  return scene::read_text(
      R"({"version": 1, "biome": "sand", "terrain": {"cells": 32})" + more + "}", "x.json");
}

scene::Scene seen_from(const dvec3& eye, const dvec2& center) {
  scene::Scene scene;
  scene.terrain.center = center;
  scene.camera.position = eye;
  scene.camera.target = eye + dvec3(1.0, 0.0, 0.0);
  return scene;
}

TEST(Resolve, CountsAllHeightsFromTheSea) {
  const scene::Scene given = small_land(
      R"(, "camera": {"height_above": "ground", "position": [50, 20, -70], "target": [900, 10, 0]},
        "lights": [{"height_above": "ground", "position": [40, 6, 30]}, {"position": [40, 6, 30]}])");
  const world::Surface surface(given);
  const scene::ResolvedScene scene = world::resolve(given, surface);
  const dvec3& balloon = given.balloon.position;
  EXPECT_EQ(scene->balloon.position.y, balloon.y + surface.height(balloon.x, balloon.z));
  EXPECT_EQ(scene.eye(), dvec3(50.0, 20.0 + surface.height(50.0, -70.0), -70.0));
  EXPECT_EQ(scene.target(), dvec3(900.0, 10.0 + surface.height(900.0, 0.0), 0.0));
  EXPECT_EQ(scene->balloon.height_above, HeightReference::sea);
  EXPECT_EQ(scene->camera.height_above, HeightReference::sea);
  EXPECT_EQ(scene->lights[0].position, dvec3(40.0, 6.0 + surface.height(40.0, 30.0), 30.0));
  EXPECT_EQ(scene->lights[0].height_above, HeightReference::sea);
  EXPECT_EQ(scene->lights[1].position, dvec3(40.0, 6.0, 30.0));
}

TEST(Resolve, OfAResolvedSceneChangesNothing) {
  for (const char* view : {"outside", "basket"}) {
    const scene::ResolvedScene once =
        world::resolve(small_land(std::string(R"(, "camera": {"view": ")") + view + "\"}"));
    const scene::ResolvedScene twice = world::resolve(*once);
    EXPECT_EQ(scene::write_text(*once), scene::write_text(*twice)) << view;
    EXPECT_EQ(once.origin(), twice.origin()) << view;
  }
}

TEST(Resolve, CarvesALandOnlyForHeightsAboveIt) {
  std::stop_source stop;
  stop.request_stop();
  // A land that is carved asks whether to stop.
  const StopScope scope(stop.get_token());
  scene::Scene scene = small_land();
  scene.terrain.kind = scene::TerrainKind::mountains;
  EXPECT_EQ(test::error_of([&] { world::resolve(scene); }).kind(), ErrorKind::interrupted);
  scene.balloon.height_above = HeightReference::sea;
  EXPECT_NO_THROW(world::resolve(scene));
}

TEST(Resolve, RefusesACameraWithoutAView) {
  scene::Scene scene = seen_from({1.0, 2.0, 3.0}, {0.0, 0.0});
  scene.balloon.height_above = HeightReference::sea;
  scene.camera.target = scene.camera.position;
  EXPECT_EQ(test::error_of([&] { world::resolve(scene); }).kind(), ErrorKind::bad_data);
}

TEST(ResolvedScene, SharesItsSceneWithCopies) {
  const scene::ResolvedScene scene = test::resolved(seen_from({1.0, 2.0, 3.0}, {0.0, 0.0}));
  const scene::ResolvedScene copy = scene, moved = scene.counted_from({7.0, 8.0, 9.0});
  EXPECT_EQ(&*copy, &*scene);
  EXPECT_EQ(&*moved, &*scene);
  EXPECT_EQ(moved.origin(), dvec3(7.0, 8.0, 9.0));
  EXPECT_EQ(scene.origin(), dvec3(0.0));
}

TEST(ResolvedScene, TakesOverTheViewOfAnother) {
  scene::Scene near = seen_from({1.0, 2.0, 3.0}, {0.0, 0.0}), far = near;
  far.camera.position = {90000.0, 2.0, 3.0};
  far.image.height = 33;
  near.sun.irradiance = 2.5;
  const scene::ResolvedScene one = test::resolved(near), other = test::resolved(far);
  const scene::ResolvedScene seen = one.seen_as(other);
  EXPECT_EQ(seen.eye(), other.eye());
  EXPECT_EQ(seen->image.height, 33);
  EXPECT_EQ(seen->sun.irradiance, 2.5);
  EXPECT_EQ(seen.origin(), one.origin());
  EXPECT_NE(seen.origin(), other.origin());
  EXPECT_EQ(one.with_image(other->image)->image.height, 33);
  EXPECT_EQ(one.with_image(other->image).eye(), one.eye());
}

TEST(Origin, OfAnExportDoesNotGoByTheCamera) {
  scene::Scene scene = seen_from({0.0, 0.0, 0.0}, {1e5, -1e5});
  const auto origin_for_export = [&] { return scene::origin_for_export(test::resolved(scene)); };
  scene.balloon.position = {1e5 + 100.0, 300.0, -1e5};
  EXPECT_EQ(origin_for_export(), dvec3(1e5, 0.0, -1e5));
  scene.balloon.position.x += 10.0 * 4096.0;
  EXPECT_EQ(origin_for_export(), dvec3(1e5 + 10.0 * 4096.0, 0.0, -1e5));
  scene.balloon.enabled = false;
  EXPECT_EQ(origin_for_export(), dvec3(1e5, 0.0, -1e5));
}

TEST(Origin, MovesNoPlaceOverTheTerrain) {
  scene::Scene given = seen_from({1e6 - 1.0, 90000.0, -1e6}, {999000.0, -1e6});
  given.terrain.base_m = 89000.0;
  given.biome.water.level_m = 89100.0;
  given.balloon.position = {1e6 - 10.0, 90001.0, -1e6};
  given.balloons.resize(1);
  given.balloons[0].position = {1e6 - 20.0, 90002.0, -1e6};
  given.lights.resize(1);
  given.lights[0].position = {1e6 - 30.0, 90003.0, -1e6};
  const scene::ResolvedScene scene = test::resolved(given);
  const dvec3& origin = scene.origin();
  EXPECT_EQ(origin, dvec3(999000.0, 22.0 * 4096.0, -1e6));
  const scene::Scene local = scene::counted_from_origin(scene);
  const dvec3 down(0.0, origin.y, 0.0);
  const auto moved = [&](const dvec3& there, const dvec3& here) {
    EXPECT_EQ(here + origin, there);
    EXPECT_EQ(scene::place_of(local, here), scene::place_of(*scene, there) - down);
  };
  moved(scene->balloon.position, local.balloon.position);
  moved(scene->balloons[0].position, local.balloons[0].position);
  moved(scene->lights[0].position, local.lights[0].position);
  moved(scene.eye(), *local.camera.position);
  moved(scene.target(), *local.camera.target);
  EXPECT_EQ(local.terrain.base_m, 89000.0 - origin.y);
  EXPECT_EQ(local.biome.water.level_m, 89100.0 - origin.y);
}

TEST(Festival, MakesBalloonsThatKeepTheirDistance) {
  const std::string festival =
      R"(, "festival": {"count": 20, "seed": 5, "center": [100, -200], "spread_m": [300, 150],
                        "lowest_m": 5, "highest_m": 120, "apart_m": 40, "burner": 0.5})";
  const scene::ResolvedScene held = world::resolve(small_land(festival));
  ASSERT_EQ(held->balloons.size(), 20u);
  EXPECT_EQ(held->festival.count, 0);
  int burning = 0;
  for (std::size_t i = 0; i < held->balloons.size(); ++i) {
    const scene::Balloon& balloon = held->balloons[i];
    EXPECT_LE(std::abs(balloon.position.x - 100.0), 300.0);
    EXPECT_LE(std::abs(balloon.position.z + 200.0), 150.0);
    EXPECT_EQ(balloon.height_above, HeightReference::sea);
    EXPECT_LE(balloon.burner, 0.5);
    burning += balloon.burner > 0.0 ? 1 : 0;
    for (std::size_t k = 0; k < i; ++k) {
      const dvec3 away = balloon.position - held->balloons[k].position;
      // Heights count from the ground when distances are kept, and the ground is not level.
      EXPECT_GT(std::hypot(away.x, away.z) + std::abs(away.y), 5.0) << i << ", " << k;
    }
  }
  EXPECT_GT(burning, 5);
  EXPECT_LT(burning, 20);
  EXPECT_EQ(world::resolve(small_land(festival))->balloons, held->balloons);
  const scene::ResolvedScene other = world::resolve(small_land(
      R"(, "festival": {"count": 20, "seed": 6, "center": [100, -200], "spread_m": [300, 150]})"));
  EXPECT_NE(other->balloons[0].position, held->balloons[0].position);
}

TEST(Festival, HasFewerBalloonsWhereThereIsNoRoom) {
  const scene::ResolvedScene held = world::resolve(small_land(
      R"(, "festival": {"count": 30, "center": [900, 900], "spread_m": [50, 50], "highest_m": 20})"));
  EXPECT_GE(held->balloons.size(), 2u);
  EXPECT_LT(held->balloons.size(), 15u);
}

}  // namespace
}  // namespace aerostat
