// Tests that plants stand only where a picture can show them or the shade that they give.
#include "scatter/sight.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/io.hpp"
#include "support/resolved.hpp"

namespace aerostat::scatter {
namespace {

/// Returns a plain with a wall of 300 m along x, 1000 m before the eye of `looking`.
mesh::GridMesh walled_plain() {
  std::vector<float> lines;
  for (int i = 0; i <= 256; ++i) lines.push_back(32.0f * static_cast<float>(i - 128));
  mesh::GridMesh mesh(lines, lines);
  for (std::uint32_t j = 0; j < lines.size(); ++j) {
    const float height = std::abs(lines[j] + 1000.0f) < 200.0f ? 300.0f : 0.0f;
    for (std::uint32_t i = 0; i < lines.size(); ++i) mesh.set(i, j, height, {0.0f, 1.0f, 0.0f});
  }
  return mesh;
}

scene::Camera looking(const dvec3& ahead) {
  scene::Camera camera;
  camera.position = {10.0, 20.0, 30.0};
  camera.target = *camera.position + ahead;
  camera.fov_y_deg = 90.0;
  return camera;
}

TEST(PlanView, IsTheAngleOfThePicture) {
  scene::Image image;
  image.width = image.height = 100000;
  const auto level = plan_view(looking({0.0, 0.0, -5.0}), image);
  ASSERT_TRUE(level);
  EXPECT_NEAR(level->left.x, -std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(level->left.y, -std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(level->right.x, std::sqrt(0.5), 1e-4);
  // The lower edge of the picture dips by 75 degrees. A point 1 m ahead there is 1 / sin(30) m to
  // the side.
  const double dip = glm::radians(30.0);
  const auto dipping = plan_view(looking({0.0, -std::sin(dip), -std::cos(dip)}), image);
  ASSERT_TRUE(dipping);
  const double ahead = std::cos(dip) - std::sin(dip);
  EXPECT_NEAR(dipping->right.x / -dipping->right.y, 1.0 / ahead, 1e-3);
  EXPECT_TRUE(dipping->touches({0.0, -50.0}, 1.0));
  EXPECT_FALSE(dipping->touches({0.0, 50.0}, 1.0));
  EXPECT_FALSE(plan_view(looking({0.0, -1.0, -0.9}), image)) << "the nadir is in the picture";
  EXPECT_FALSE(plan_view(looking({0.0, 5.0, -1.0}), image)) << "the zenith is in the picture";
}

TEST(Sight, StopsBehindAWallAndGoesOnInTheWallsShade) {
  const mesh::GridMesh wall = walled_plain();
  scene::Scene scene = scene::defaults(scene::BiomeKind::snow, scene::View::outside);
  scene.camera = looking({0.0, 0.0, -5.0});
  scene.camera.fov_y_deg = 45.0;
  scene.balloon.enabled = false;
  scene.biome.water.enabled = false;
  scene.sky.ambient_occlusion = false;
  scene.sun.direction = glm::normalize(dvec3(0.0, 1.0, 2.0));
  const Sight sight(test::resolved(scene), wall, 3000.0, {10.0, 20.0});
  EXPECT_TRUE(sight.matters(0.0, -500.0));
  EXPECT_TRUE(sight.matters(0.0, -850.0));
  EXPECT_FALSE(sight.matters(0.0, -2000.0)) << "behind the wall";
  EXPECT_FALSE(sight.matters(-2500.0, -500.0)) << "aside";
  EXPECT_FALSE(sight.matters(0.0, 300.0)) << "behind the eye";
  scene.sun.direction = glm::normalize(dvec3(-10.0, 0.4, 0.0));
  EXPECT_TRUE(Sight(test::resolved(scene), wall, 3000.0, {10.0, 20.0}).matters(-800.0, -500.0))
      << "aside, its shadow of 500 m in the picture";
  EXPECT_FALSE(Sight(test::resolved(scene), wall, 3000.0, {10.0, 20.0}).matters(-1300.0, -500.0));
  EXPECT_FALSE(Sight(test::resolved(scene), wall, 3000.0, {10.0, 20.0}).matters(800.0, -500.0));
  scene.sun.direction = glm::normalize(dvec3(0.0, 1.0, -2.0));
  EXPECT_FALSE(Sight(test::resolved(scene), wall, 3000.0, {10.0, 20.0}).matters(0.0, -2000.0))
      << "its shadow falls on the wall's back";
}

}  // namespace
}  // namespace aerostat::scatter
