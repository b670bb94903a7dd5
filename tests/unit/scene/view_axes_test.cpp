// Tests the right, up and ahead axes of a camera, above all if its up vector does not determine
// them.
#include "scene/view_axes.hpp"

#include <gtest/gtest.h>

#include "scene/picture.hpp"
#include "support/error_of.hpp"

namespace aerostat::scene {
namespace {

constexpr Lens kLenses[] = {Lens::pinhole, Lens::thin_lens, Lens::panorama, Lens::orthographic};

Camera looking(const dvec3& sight, const dvec3& up = {0.0, 1.0, 0.0}, Lens lens = Lens::pinhole) {
  Camera camera;
  camera.position = {100.0, 20.0, -7.0};
  camera.target = *camera.position + sight;
  camera.up = up;
  camera.lens = lens;
  return camera;
}

void expect_near(const dvec3& actual, const dvec3& expected) {
  EXPECT_LT(glm::distance(actual, expected), 1e-9)
      << actual.x << ' ' << actual.y << ' ' << actual.z;
}

TEST(ViewAxes, StraightDownHasNorthAtTheTop) {
  for (const Lens lens : kLenses) {
    if (lens == Lens::panorama) continue;
    const ViewAxes axes = view_axes(looking({0.0, -30.0, 0.0}, {0.0, 1.0, 0.0}, lens));
    expect_near(axes.right, {1.0, 0.0, 0.0});
    expect_near(axes.up, {0.0, 0.0, -1.0});
    expect_near(axes.forward, {0.0, -1.0, 0.0});
  }
}

TEST(ViewAxes, StraightUpHasSouthAtTheTop) {
  for (const double y : {1.0, -5.0}) {
    const ViewAxes axes = view_axes(looking({0.0, 30.0, 0.0}, {0.0, y, 0.0}));
    expect_near(axes.right, {1.0, 0.0, 0.0});
    expect_near(axes.up, {0.0, 0.0, 1.0});
    expect_near(axes.forward, {0.0, 1.0, 0.0});
  }
}

TEST(ViewAxes, OfAPanoramaKeepTheUpVectorAndFaceNorth) {
  for (const double y : {-30.0, 30.0}) {
    const ViewAxes axes = view_axes(looking({0.0, y, 0.0}, {0.0, 1.0, 0.0}, Lens::panorama));
    expect_near(axes.right, {1.0, 0.0, 0.0});
    expect_near(axes.up, {0.0, 1.0, 0.0});
    expect_near(axes.forward, {0.0, 0.0, -1.0});
  }
}

TEST(ViewAxes, HaveYUprightWhereTheUpVectorLiesAlongASlantedView) {
  for (const dvec3& sight : {dvec3(1.0, 0.0, 0.0), dvec3(3.0, -4.0, 2.0)}) {
    for (const double length : {1.0, -1000.0}) {
      const ViewAxes along = view_axes(looking(sight, glm::normalize(sight) * length));
      const ViewAxes upright = view_axes(looking(sight));
      expect_near(along.right, upright.right);
      expect_near(along.up, upright.up);
    }
  }
}

TEST(ViewAxes, FollowAnUpVectorThatIsHardlyOffTheView) {
  const ViewAxes axes = view_axes(looking({0.0, -1.0, 0.0}, {1e-4, 1.0, 0.0}));
  expect_near(axes.up, {1.0, 0.0, 0.0});
  const ViewAxes within = view_axes(looking({0.0, -1.0, 0.0}, {1e-7, 1.0, 0.0}));
  expect_near(within.up, {0.0, 0.0, -1.0});
}

TEST(ViewAxes, AreUnitVectorsAtRightAnglesWhateverTheLengths) {
  for (const double length : {1e-300, 1e-12, 1.0, 1e6}) {
    for (const double up : {1e-300, 1.0, 1000.0}) {
      Camera camera = looking({0.0, 0.0, 0.0});
      camera.position = dvec3(0.0);
      camera.target = dvec3(1.0, -2.0, 0.5) * length;
      camera.up = dvec3(0.1, 0.9, 0.3) * up;
      const ViewAxes axes = view_axes(camera);
      EXPECT_NEAR(glm::length(axes.forward), 1.0, 1e-12) << length << ' ' << up;
      EXPECT_NEAR(glm::length(axes.right), 1.0, 1e-12);
      expect_near(glm::cross(axes.right, axes.forward), axes.up);
      EXPECT_NEAR(glm::dot(axes.right, axes.forward), 0.0, 1e-12);
    }
  }
}

TEST(ViewAxes, NeedATargetApartFromThePosition) {
  const Error error = test::error_of([] { view_axes(looking({0.0, 0.0, 0.0})); });
  EXPECT_EQ(error.kind(), ErrorKind::bad_data);
  EXPECT_STREQ(error.what(),
               "/camera/target: found the camera's own position, expected another point");
}

}  // namespace
}  // namespace aerostat::scene
