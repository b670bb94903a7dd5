// Tests an eye that a coarse land would bury.
#include <algorithm>

#include <gtest/gtest.h>

#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"
#include "world/world.hpp"

namespace aerostat {
namespace {

constexpr int kCells = 192;

class BuriedEye : public testing::Test {
 protected:
  BuriedEye() {
    scene_ = scene::read_text(
        R"({"version": 1, "terrain": {"cells": 192, "erosion": 0}, "vegetation": {"enabled": false},
            "camera": {"height_above": "sea", "position": [0, 0, 0], "target": [0, 5, -9]}})",
        "x.json");
    scene_.balloon.enabled = false;
  }

  scene::Scene scene_;
};

TEST_F(BuriedEye, IsLiftedAboveTheMesh) {
  const world::Surface surface(scene_, world::Carving::coarse);
  const auto world =
      world::build(world::resolve(scene_, surface), {.carving = world::Carving::coarse});
  const mesh::GridMesh& ground = *world::shape_of<world::HeightGrid>(world, world::kLand)->mesh;
  for (std::uint32_t j = 1; j < kCells; j += 7) {
    for (std::uint32_t i = 1; i < kCells; i += 7) {
      const double x = 0.5 * (ground.x(i) + ground.x(i + 1));
      const double z = 0.5 * (ground.z(j) + ground.z(j + 1));
      scene::Scene buried = scene_;
      buried.camera.position = {x, -500.0, z};
      buried.camera.target = {x, -490.0, z - 20.0};
      const auto seen = world::with_eye_unburied(world::resolve(buried, surface), surface, kCells);
      const float diagonals[] = {ground.height(i, j) + ground.height(i + 1, j + 1),
                                 ground.height(i + 1, j) + ground.height(i, j + 1)};
      const double mesh = 0.5 * std::max(diagonals[0], diagonals[1]);
      // The mesh leaves out shapes that are finer than its cells.
      EXPECT_GT(seen.eye().y, mesh - 25.0) << x << ' ' << z;
      EXPECT_NEAR(seen.target().y - seen.eye().y, 10.0, 1e-6);
    }
  }
}

TEST_F(BuriedEye, OneInTheOpenStays) {
  const world::Surface surface(scene_, world::Carving::coarse);
  scene_.camera.position->y = surface.height(0.0, 0.0) + 4000.0;
  const scene::ResolvedScene scene = world::resolve(scene_, surface);
  EXPECT_EQ(world::with_eye_unburied(scene, surface, kCells).eye(), *scene_.camera.position);
}

}  // namespace
}  // namespace aerostat
