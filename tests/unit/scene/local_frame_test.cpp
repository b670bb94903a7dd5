// Tests the origin from which all meshes count.
#include "scene/local_frame.hpp"

#include <gtest/gtest.h>

#include "scene/scene.hpp"

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
      const dvec3 place = place_of(scene, origin);
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

}  // namespace
}  // namespace aerostat::scene
