// Tests the movements of the camera.
#include "viewer/camera_motion.hpp"

#include <QtTest>
#include <cmath>
#include <numbers>

namespace aerostat::viewer {
namespace {

bool near(const dvec3& a, const dvec3& b, double tolerance = 1e-9) {
  return glm::distance(a, b) < tolerance;
}

}  // namespace

class CameraMotionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void orbit_keeps_the_target_and_its_distance();
  void orbit_goes_round();
  void nothing_goes_over_the_poles();
  void straight_down_has_north_at_the_top();
  void looking_keeps_the_eye();
  void dolly_stops_before_the_target();
  void flight_follows_the_sight();
  void ground_lifts_the_eye();
  void directions_of_a_picture();

 private:
  const Pose pose_{{10.0, 20.0, 30.0}, {4.0, 11.0, -7.0}};
};

void CameraMotionTest::orbit_keeps_the_target_and_its_distance() {
  const Pose turned = orbit(pose_, 0.7, 0.2);
  QVERIFY(near(turned.target, pose_.target));
  QVERIFY(std::abs(glm::distance(turned.position, turned.target) -
                   glm::distance(pose_.position, pose_.target)) < 1e-9);
  QVERIFY(!near(turned.position, pose_.position, 1.0));
}

void CameraMotionTest::orbit_goes_round() {
  QVERIFY(near(orbit(pose_, 2.0 * std::numbers::pi, 0.0).position, pose_.position));
  // Seen from the south, the picture's content moves to the right when the eye moves left, which is
  // west.
  const Pose south{{0.0, 0.0, 10.0}, {0.0, 0.0, 0.0}};
  QVERIFY(near(orbit(south, 0.5 * std::numbers::pi, 0.0).position, {-10.0, 0.0, 0.0}));
  // The picture's content moves down when the eye moves up.
  QVERIFY(orbit(south, 0.0, 0.3).position.y > 0.0);
}

void CameraMotionTest::nothing_goes_over_the_poles() {
  for (const double turn : {3.0, -3.0}) {
    const dvec3 sight = glm::normalize(pose_.target - orbit(pose_, 0.0, turn).position);
    QVERIFY(std::hypot(sight.x, sight.z) > 0.01);
    const Pose looked = look(pose_, 0.0, turn);
    const dvec3 seen = glm::normalize(looked.target - looked.position);
    QVERIFY(std::hypot(seen.x, seen.z) > 0.01);
  }
}

void CameraMotionTest::straight_down_has_north_at_the_top() {
  const Pose down{{0.0, 50.0, 0.0}, {0.0, 0.0, 0.0}};
  scene::Camera camera;
  camera.position = down.position;
  camera.target = down.target;
  camera.fov_y_deg = 90.0;
  QVERIFY(near(sight_at(camera, 1.0, 0.5, 0.5).direction, {0.0, -1.0, 0.0}));
  QVERIFY(near(sight_at(camera, 1.0, 0.5, 0.0).direction, glm::normalize(dvec3(0.0, -1.0, -1.0))));
  camera.lens = scene::Lens::panorama;
  QVERIFY(near(sight_at(camera, 2.0, 0.5, 0.5).direction, {0.0, 0.0, -1.0}));
  // The movements agree with the view: right is east, and tilting the camera up makes it look
  // north.
  QVERIFY(near(fly(down, {0.0, 1.0, 0.0}, 3.0).position, {3.0, 50.0, 0.0}));
  const Pose tilted = look(down, 0.0, 0.5 * std::numbers::pi);
  QVERIFY(near(glm::normalize(tilted.target - tilted.position), {0.0, 0.0, -1.0}));
}

void CameraMotionTest::looking_keeps_the_eye() {
  const Pose north{{0.0, 0.0, 0.0}, {0.0, 0.0, -5.0}};
  const Pose turned = look(north, 0.5 * std::numbers::pi, 0.0);
  QVERIFY(near(turned.position, north.position));
  QVERIFY(near(turned.target, {-5.0, 0.0, 0.0}));
  QVERIFY(look(north, 0.0, 0.1).target.y > 0.0);
}

void CameraMotionTest::dolly_stops_before_the_target() {
  const Pose closer = dolly(pose_, 0.5);
  QVERIFY(near(closer.position, 0.5 * (pose_.position + pose_.target)));
  QVERIFY(std::abs(glm::distance(dolly(pose_, 0.0).position, pose_.target) - 0.5) < 1e-9);
  QVERIFY(near(dolly(closer, 2.0).position, pose_.position));
}

void CameraMotionTest::flight_follows_the_sight() {
  const Pose north{{0.0, 0.0, 0.0}, {0.0, 0.0, -5.0}};
  const Pose flown = fly(north, {1.0, 1.0, 1.0}, 2.0);
  QVERIFY(near(flown.position, {2.0, 2.0, -2.0}));
  QVERIFY(near(flown.target - flown.position, north.target - north.position));
  QVERIFY(flight_speed(0.0) > 0.0);
  QVERIFY(flight_speed(1000.0) > flight_speed(10.0));
}

void CameraMotionTest::ground_lifts_the_eye() {
  const auto hill = [](double x, double) { return x > 5.0 ? 100.0 : 0.0; };
  const Pose lifted = above_ground(pose_, hill);
  QCOMPARE(lifted.position.y, 100.0 + kEyeClearance_m);
  QVERIFY(near(lifted.target - lifted.position, pose_.target - pose_.position));
  const Pose free{{0.0, 20.0, 0.0}, {0.0, 20.0, -1.0}};
  QVERIFY(near(above_ground(free, hill).position, free.position));
}

void CameraMotionTest::directions_of_a_picture() {
  scene::Camera camera;
  camera.position = dvec3(0.0);
  camera.target = {0.0, 0.0, -1.0};
  camera.fov_y_deg = 90.0;
  const auto direction = [&](double x, double y) { return sight_at(camera, 2.0, x, y).direction; };
  QVERIFY(near(direction(0.5, 0.5), {0.0, 0.0, -1.0}));
  QVERIFY(near(direction(0.5, 0.0), glm::normalize(dvec3(0.0, 1.0, -1.0))));
  QVERIFY(near(direction(1.0, 0.5), glm::normalize(dvec3(2.0, 0.0, -1.0))));
  camera.lens = scene::Lens::panorama;
  QVERIFY(near(direction(0.5, 0.0), {0.0, 1.0, 0.0}));
  QVERIFY(near(direction(0.75, 0.5), {1.0, 0.0, 0.0}));
  camera.lens = scene::Lens::orthographic;
  camera.view_height_m = 10.0;
  QVERIFY(near(direction(1.0, 0.0), {0.0, 0.0, -1.0}));
  QVERIFY(near(sight_at(camera, 2.0, 1.0, 0.0).origin, {10.0, 5.0, 0.0}));
}

}  // namespace aerostat::viewer

QTEST_GUILESS_MAIN(aerostat::viewer::CameraMotionTest)
#include "camera_motion_test.moc"
