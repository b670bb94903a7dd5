// Tests which plants a session places and when it places them again.
#include <cmath>

#include "core/error.hpp"
#include "pictures.hpp"

namespace aerostat::test {
namespace {

using render::Session;

TEST(Plants, FollowTheCameraAlone) {
  Session session(options());
  auto scene = planted_scene("snow");
  session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 3);
  scene.sun.direction = glm::normalize(dvec3(-0.6, 0.5, 0.3));
  session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 0);
  *scene.camera.position += dvec3(0.3, 0.1, -0.5);
  const auto moved = session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 1);
  EXPECT_TRUE(same_bits(moved, Session(options()).render(resolved(scene))));
}

TEST(Plants, StayBelowABalloonThatDriftsAndBesideWavesThatRun) {
  render::Options single = options();
  single.use = render::Use::single_picture;
  Session session(single);
  auto scene = planted_scene("snow");
  scene.balloon.position = {4.0, 120.0, 4.0};
  session.render(resolved(scene));
  scene.balloon.position += dvec3(0.5, 0.3, 0.2);
  scene.biome.water.time_s = 2.0;
  const auto drifted = session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 1) << "only the balloon";
  EXPECT_TRUE(same_bits(drifted, Session(single).render(resolved(scene))));
  scene.balloon.position.x += 40.0;
  const auto far = session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 2) << "another square";
  EXPECT_TRUE(same_bits(far, Session(single).render(resolved(scene))));
  // A balloon near the ground keeps plants away.
  scene.balloon.position.y = 3.0;
  session.render(resolved(scene));
  scene.balloon.position.x += 0.5;
  const auto low = session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 2);
  EXPECT_TRUE(same_bits(low, Session(single).render(resolved(scene))));
}

TEST(Plants, MayStayAsTheyStand) {
  Session session(options());
  auto scene = planted_scene("snow");
  session.render(resolved(scene));
  const auto first_eye = *scene.camera.position;
  *scene.camera.position += dvec3(-3.0, -1.0, 5.0);
  const auto as_they_stand = [&] {
    return session.render(resolved(scene), {}, {}, {}, render::Plants::as_they_stand);
  };
  const auto moved = as_they_stand();
  EXPECT_EQ(session.stats().worlds_built, 0);
  scene.camera.position = first_eye;
  as_they_stand();
  session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 0) << "they are the first eye's";
  *scene.camera.position += dvec3(-3.0, -1.0, 5.0);
  const auto exact = session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 1);
  EXPECT_FALSE(same_bits(moved, exact));
  EXPECT_TRUE(same_bits(exact, Session(options()).render(resolved(scene))));
}

TEST(Plants, StayOnlyInAnInteractiveSession) {
  render::Options single = options();
  single.use = render::Use::single_picture;
  Session session(single);
  const scene::ResolvedScene scene = resolved(small_scene("sand-empty"));
  EXPECT_THROW(session.render(scene, {}, {}, {}, render::Plants::as_they_stand), Error);
  EXPECT_EQ(session.render(scene).width, scene->image.width) << "the session goes on";
}

/// Returns the scene's own view for k = 0, and views to other sides for other k.
scene::Scene seen_from_aside(const std::string& name, int k) {
  auto scene = planted_scene(name, {192, 108, 1, 256});
  scene.vegetation.reach_m = 3000.0;
  if (k == 0) return scene;
  scene::Camera& camera = scene.camera;
  const double angle = 1.7 * k;
  const dvec3 ahead(std::cos(angle), k == 3 ? -2.0 : -0.15, std::sin(angle));
  camera.target = *camera.position + 100.0 * ahead;
  camera.up = {0.3 * k, 1.0, 0.2};
  scene.sun.direction = glm::normalize(dvec3(std::sin(angle), 0.25, -std::cos(angle)));
  return scene;
}

TEST(Plants, OutOfSightAreNoLoss) {
  render::Options in_sight = options();
  in_sight.use = render::Use::single_picture;
  Session all(options()), some(in_sight);
  for (const char* name : {"snow-basket", "tropical-basket"}) {
    for (int k = 0; k < 4; ++k) {
      const auto scene = seen_from_aside(name, k);
      const auto expected = all.render(resolved(scene));
      EXPECT_TRUE(same_bits(expected, some.render(resolved(scene)))) << name << " " << k;
      EXPECT_LT(some.stats().tree.leaves, all.stats().tree.leaves);
    }
  }
}

}  // namespace
}  // namespace aerostat::test
