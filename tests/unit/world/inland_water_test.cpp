// Tests lakes of real land and the sea over its curved ground.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iomanip>
#include <string>

#include <gtest/gtest.h>

#include "core/earth.hpp"
#include "scene/io.hpp"
#include "support/resolved.hpp"
#include "support/temporary_folder.hpp"
#include "world/world.hpp"

namespace aerostat {
namespace {

using PlaceFunction = std::function<double(double east, double north)>;

/// Writes an .asc file of whole numbers around a point of UTM zone 32.
std::string write_asc(const test::TemporaryFolder& folder, const char* name, int side, double cell,
                      const PlaceFunction& value) {
  const auto path = folder.path() / name;
  std::ofstream file(path);
  const double half = 0.5 * (side - 1) * cell;
  file << std::setprecision(10) << "ncols " << side << "\nnrows " << side << "\nxllcenter "
       << 500000.0 - half << "\nyllcenter " << 5200000.0 - half << "\ncellsize " << cell << '\n';
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i)
      file << std::round(value(i * cell - half, half - j * cell)) << ' ';
    file << '\n';
  }
  return path.string();
}

/// Returns a scene on heights of whole metres.
scene::Scene scene_on(const test::TemporaryFolder& folder, int side, double cell,
                      const PlaceFunction& height) {
  scene::Scene scene = scene::read_text(
      R"({"version": 1, "biome": "meadow", "terrain": {"kind": "elevation", "source": ")" +
          write_asc(folder, "land.asc", side, cell, height) +
          R"(", "crs": "EPSG:32632", "grading": 1, "detail": 0}})",
      "x.json");
  scene.terrain.size_m = 0.95 * side * cell;
  scene.terrain.cells = side;
  scene.vegetation.enabled = false;
  scene.camera.position = {0.0, 3000.0, 0.0};
  scene.camera.target = {0.0, 0.0, -1000.0};
  return scene;
}

/// Returns -1 to 1, which differs from place to place.
double rough(double east, double north) {
  const double wave = std::sin(0.37 * east + 1.3 * std::sin(0.21 * north)) * 43758.5;
  return 2.0 * (wave - std::floor(wave)) - 1.0;
}

/// A lake at 400 m, 500 m in radius, whose middle lies to the east.
double lake(double east, double north) {
  return 400.0 + std::max(0.0, 0.3 * (std::hypot(east - 600.0, north) - 500.0));
}

TEST(InlandWater, LakesLieAtTheirLevelOverACarvedBed) {
  const test::TemporaryFolder folder;
  const scene::Scene scene = scene_on(folder, 81, 30.0, lake);
  const world::World world = world::build(world::resolve(scene));
  const auto* lakes = world::shape_of<world::Objects>(world, world::kInlandWater);
  ASSERT_NE(lakes, nullptr);
  ASSERT_EQ(lakes->size(), 1u);
  const mesh::TriangleMesh& mesh = lakes->front().mesh;
  float deepest = 0.0f, farthest = 0.0f;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const dvec3 p = dvec3(mesh.positions[i]) + world.scene.origin();
    EXPECT_NEAR(p.y, 400.0 - kEarthFall_per_m * (p.x * p.x + p.z * p.z), 0.01);
    EXPECT_EQ(mesh.colors[i].y, 1.0f);
    deepest = std::max(deepest, mesh.colors[i].x);
    farthest = std::max(farthest, static_cast<float>(std::hypot(p.x - 600.0, p.z)));
  }
  EXPECT_GT(deepest, 15.0f);
  EXPECT_LT(deepest, 30.0f);
  EXPECT_NEAR(farthest, 510.0f, 45.0f);
  const world::Surface surface(scene);
  EXPECT_NEAR(surface.height(600.0, 0.0), 400.0, 0.1);
}

// Heights from radar are noisy on water. Land cover says where it is.
TEST(InlandWater, OfLandCoverHasTheHeightOfTheLand) {
  const test::TemporaryFolder folder;
  scene::Scene scene = scene_on(folder, 81, 30.0, [](double east, double north) {
    return lake(east, north) + 2.0 * rough(east, north);
  });
  const PlaceFunction codes = [](double east, double north) {
    return std::hypot(east - 600.0, north) < 500.0 ? 80.0 : 30.0;
  };
  scene.terrain.cover.source = write_asc(folder, "cover.asc", 81, 30.0, codes);
  scene.terrain.cover.crs = "EPSG:32632";
  const world::World world = world::build(world::resolve(scene));
  const auto* lakes = world::shape_of<world::Objects>(world, world::kInlandWater);
  ASSERT_EQ(lakes->size(), 1u);
  float farthest = 0.0f;
  for (const vec3& position : lakes->front().mesh.positions) {
    const dvec3 p = dvec3(position) + world.scene.origin();
    EXPECT_NEAR(p.y, 400.0, 1.6);
    farthest = std::max(farthest, static_cast<float>(std::hypot(p.x - 600.0, p.z)));
  }
  EXPECT_NEAR(farthest, 510.0f, 60.0f);
}

TEST(InlandWater, RiversOfLandCoverFallWithTheLand) {
  const test::TemporaryFolder folder;
  // A valley that falls by 1 % to the east, with a river of 150 m.
  scene::Scene scene = scene_on(folder, 81, 30.0, [](double east, double north) {
    return 500.0 - 0.01 * east + std::max(0.0, 0.2 * (std::abs(north) - 75.0));
  });
  const PlaceFunction codes = [](double, double north) { return std::abs(north) < 75.0 ? 11 : 71; };
  scene.terrain.cover.source = write_asc(folder, "cover.asc", 81, 30.0, codes);
  scene.terrain.cover.crs = "EPSG:32632";
  const world::World world = world::build(world::resolve(scene));
  const auto* rivers = world::shape_of<world::Objects>(world, world::kInlandWater);
  ASSERT_EQ(rivers->size(), 1u);
  double west = 0.0, east = 0.0;
  for (const vec3& position : rivers->front().mesh.positions) {
    const dvec3 p = dvec3(position) + world.scene.origin();
    EXPECT_LT(std::abs(p.z), 140.0);
    EXPECT_NEAR(p.y, 499.0 - 0.01 * p.x, 2.0);
    west = std::min(west, p.x);
    east = std::max(east, p.x);
  }
  EXPECT_LT(west, -1000.0);
  EXPECT_GT(east, 1000.0);
}

TEST(InlandWater, IsDryIfTheSceneSaysSo) {
  const test::TemporaryFolder folder;
  scene::Scene scene = scene_on(folder, 81, 30.0, lake);
  scene.terrain.inland_water = scene::InlandWater::none;
  const world::World world = world::build(world::resolve(scene));
  EXPECT_TRUE(world::shape_of<world::Objects>(world, world::kInlandWater)->empty());
  // Heights of whole metres are smoothed by at most half a metre.
  EXPECT_NEAR(world::Surface(scene).height(600.0, 0.0), 400.0, 0.51);
}

TEST(InlandWater, PlantsDoNotStandInIt) {
  const test::TemporaryFolder folder;
  scene::Scene scene = scene_on(folder, 81, 30.0, lake);
  scene.vegetation.enabled = true;
  scene.vegetation.reach_m = 1200.0;
  const world::World world = world::build(world::resolve(scene));
  const auto* plants = world::shape_of<world::Instances>(world, world::kPlants);
  ASSERT_NE(plants, nullptr);
  int near = 0;
  for (const scatter::Instance& plant : plants->places) {
    const dvec3 p = dvec3(plant.position) + world.scene.origin();
    const double away = std::hypot(p.x - 600.0, p.z);
    EXPECT_GT(away, 480.0);
    if (away < 700.0) ++near;
  }
  EXPECT_GT(near, 50);
}

TEST(Sea, IsCurvedAsTheLandIs) {
  const test::TemporaryFolder folder;
  scene::Scene scene =
      scene_on(folder, 101, 400.0, [](double east, double) { return east > 0.0 ? 50.0 : -20.0; });
  scene.biome.water.enabled = true;
  for (const bool curved : {true, false}) {
    scene.terrain.curved = curved;
    const world::World world = world::build(world::resolve(scene));
    const auto* sea = world::shape_of<world::Objects>(world, world::kSea);
    ASSERT_EQ(sea->size(), 1u);
    double lowest = 0.0, most_east = -1e9;
    for (const vec3& position : sea->front().mesh.positions) {
      const dvec3 p = dvec3(position) + world.scene.origin();
      const double fall = curved ? kEarthFall_per_m * (p.x * p.x + p.z * p.z) : 0.0;
      EXPECT_NEAR(p.y, -fall, 0.01);
      lowest = std::min(lowest, p.y);
      most_east = std::max(most_east, p.x);
    }
    EXPECT_NEAR(lowest, curved ? -49.0 : 0.0, 3.0);
    EXPECT_LT(most_east, 900.0);  // land that lies lower because of the curvature stays dry
    EXPECT_NEAR(world::Surface(scene).height(-19000.0, 0.0),
                curved ? -kEarthFall_per_m * 19000.0 * 19000.0 : 0.0, 0.01);
  }
}

}  // namespace
}  // namespace aerostat
