// Tests the origin from which all meshes count.
#include "scene/local_frame.hpp"

#include <gtest/gtest.h>

namespace aerostat::scene {
namespace {

Scene seen_from(const dvec3& eye, const dvec2& center = {0.0, 0.0}) {
  Scene scene;
  scene.terrain.center = center;
  scene.camera.position = eye;
  scene.camera.target = eye + dvec3(1.0, 0.0, 0.0);
  return scene;
}

TEST(Origin, IsTheCentreOfTheTerrainForAnEyeNearIt) {
  EXPECT_EQ(origin_for(seen_from({0.0, 0.0, 0.0})), dvec3(0.0));
  EXPECT_EQ(origin_for(seen_from({8191.0, -8191.0, -8191.0})), dvec3(0.0));
  EXPECT_EQ(origin_for(seen_from({1e6, 8000.0, -1e6}, {1e6 + 0.25, -1e6})),
            dvec3(1e6 + 0.25, 0.0, -1e6));
}

TEST(Origin, IsNeverFarFromTheEye) {
  for (const double far : {8192.0, 10000.0, 99999.0, 123456.789, 1e6}) {
    for (const double side : {-1.0, 1.0}) {
      const dvec3 eye = side * dvec3(far, 0.5 * far, -2.0 * far);
      const Scene scene = seen_from(eye, {17.3, -4.1});
      const dvec3 origin = origin_for(scene);
      for (int axis = 0; axis < 3; ++axis) EXPECT_LT(std::abs(eye[axis] - origin[axis]), 8192.0);
      Scene resolved = scene;
      resolved.origin = origin;
      const dvec3 place = place_of(resolved, origin);
      // Single precision holds this place, except for the rounding of world coordinates in double
      // precision.
      EXPECT_LT(glm::distance(place, dvec3(vec3(place))), 1e-9);
    }
  }
}

TEST(Origin, FollowsTheTargetOfParallelRays) {
  Scene scene = seen_from({1e6, 300.0, 0.0});
  scene.camera.target = {5.0, 200.0, 5.0};
  scene.camera.lens = Lens::orthographic;
  EXPECT_EQ(origin_for(scene), dvec3(0.0));
}

TEST(Origin, OfAnExportDoesNotGoByTheCamera) {
  Scene scene = seen_from({0.0, 0.0, 0.0}, {1e5, -1e5});
  scene.balloon.position = {1e5 + 100.0, 300.0, -1e5};
  EXPECT_EQ(origin_for_export(scene), dvec3(1e5, 0.0, -1e5));
  scene.balloon.position.x += 10.0 * 4096.0;
  EXPECT_EQ(origin_for_export(scene), dvec3(1e5 + 10.0 * 4096.0, 0.0, -1e5));
  scene.balloon.enabled = false;
  EXPECT_EQ(origin_for_export(scene), dvec3(1e5, 0.0, -1e5));
}

TEST(Origin, MovesNoPlaceOverTheTerrain) {
  Scene scene = seen_from({1e6, 90000.0, -1e6}, {999000.0, -1e6});
  scene.terrain.base_m = 89000.0;
  scene.biome.water.level_m = 89100.0;
  scene.balloon.position = {1e6 + 10.0, 90001.0, -1e6};
  scene.balloons.resize(1);
  scene.balloons[0].position = {1e6 + 20.0, 90002.0, -1e6};
  scene.lights.resize(1);
  scene.lights[0].position = {1e6 + 30.0, 90003.0, -1e6};
  scene.origin = origin_for(scene);
  EXPECT_EQ(scene.origin, dvec3(999000.0, 22.0 * 4096.0, -1e6));
  const Scene local = counted_from_origin(scene);
  const dvec3 down(0.0, scene.origin.y, 0.0);
  const auto moved = [&](const dvec3& there, const dvec3& here) {
    EXPECT_EQ(here + scene.origin, there);
    EXPECT_EQ(place_of(local, here), place_of(scene, there) - down);
  };
  moved(scene.balloon.position, local.balloon.position);
  moved(scene.balloons[0].position, local.balloons[0].position);
  moved(scene.lights[0].position, local.lights[0].position);
  moved(*scene.camera.position, *local.camera.position);
  moved(*scene.camera.target, *local.camera.target);
  EXPECT_EQ(local.terrain.base_m, 89000.0 - scene.origin.y);
  EXPECT_EQ(local.biome.water.level_m, 89100.0 - scene.origin.y);
}

}  // namespace
}  // namespace aerostat::scene
