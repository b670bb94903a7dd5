// Tests that plants stand on the ground, where their biome allows them, in the right number.
#include "scatter/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <tuple>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/error.hpp"
#include "ground/ground_numbers.hpp"
#include "mesh_over.hpp"
#include "scatter/layer.hpp"
#include "scene/io.hpp"
#include "support/resolved.hpp"
#include "terrain/terrain_mesh.hpp"

namespace aerostat::scatter {
namespace {

using plant::Species;
using scene::BiomeKind;

/// Returns a small version of a biome's usual land, seen from a place with all kinds of ground.
scene::Scene small_scene(BiomeKind kind) {
  scene::Scene scene = scene::defaults(kind, scene::View::outside);
  scene.terrain.cells = 256;
  scene.vegetation.reach_m = 2500.0;
  scene.camera.position = {-600.0, 500.0, 300.0};
  scene.balloon.position = {0.0, 600.0, 0.0};
  return scene;
}

/// Returns the height over a place of a terrain_mesh, found by trying all its triangles.
double brute_height(const mesh::TriangleMesh& mesh, double x, double z) {
  double found = -1e30;
  for (const uvec3& t : mesh.triangles) {
    const vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
    if (x < static_cast<double>(std::min({a.x, b.x, c.x})) ||
        x > static_cast<double>(std::max({a.x, b.x, c.x}))) {
      continue;
    }
    const dvec2 ab(b.x - a.x, b.z - a.z), ac(c.x - a.x, c.z - a.z);
    const dvec2 p(x - static_cast<double>(a.x), z - static_cast<double>(a.z));
    const double area = ab.x * ac.y - ac.x * ab.y;
    const double u = (p.x * ac.y - ac.x * p.y) / area, v = (ab.x * p.y - p.x * ab.y) / area;
    if (u < -1e-9 || v < -1e-9 || u + v > 1.0 + 1e-9) continue;
    found = static_cast<double>(a.y) + u * static_cast<double>(b.y - a.y) +
            v * static_cast<double>(c.y - a.y);
  }
  return found;
}

TEST(Surface, IsTheMeshToTheMillimetre) {
  for (const auto kind : {scene::TerrainKind::mountains, scene::TerrainKind::dunes}) {
    scene::Terrain terrain;
    terrain.kind = kind;
    terrain.cells = 40;
    terrain.size_m = 4000.0;
    terrain.center = {300.0, -200.0};
    const mesh::GridMesh ground = terrain::terrain_mesh(terrain);
    const mesh::TriangleMesh triangles = mesh::to_triangles(ground);
    const Surface surface(ground);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> offset(-1999.0, 1999.0);
    for (int k = 0; k < 500; ++k) {
      const double x = 300.0 + offset(random), z = -200.0 + offset(random);
      const SurfacePoint point = surface.at(x, z);
      ASSERT_NEAR(static_cast<double>(point.position.y), brute_height(triangles, x, z), 2e-3);
      ASSERT_NEAR(glm::length(point.normal), 1.0f, 1e-5f);
    }
    // Outside the mesh, its rim continues level.
    EXPECT_EQ(surface.height(1e6, 0.0), surface.height(2300.0, 0.0));
  }
}

class Biome : public testing::TestWithParam<BiomeKind> {
 protected:
  void SetUp() override {
    scene = small_scene(GetParam());
    ground = terrain::terrain_mesh(scene.terrain);
    growth = scatter(test::resolved(scene), ground);
    ASSERT_GT(growth.instances.size(), 1000u);
  }

  Species species_of(const Instance& instance) const {
    return growth.models[instance.model].species;
  }

  scene::Scene scene;
  mesh::GridMesh ground;
  Growth growth;
};

std::string name_of(const testing::TestParamInfo<BiomeKind>& info) {
  const char* names[] = {"snow", "tropical", "sand", "meadow"};
  return names[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Every, Biome,
                         testing::Values(BiomeKind::snow, BiomeKind::tropical, BiomeKind::sand,
                                         BiomeKind::meadow),
                         name_of);

TEST_P(Biome, PutsEverythingOnTheGround) {
  const Surface surface(ground);
  for (const Instance& instance : growth.instances) {
    const vec3& p = instance.position;
    ASSERT_NEAR(p.y, surface.height(static_cast<double>(p.x), static_cast<double>(p.z)), 0.01f);
    ASSERT_LT(instance.model, growth.models.size());
    ASSERT_GT(instance.scale, 0.0f);
    ASSERT_LT(glm::length(instance.lean), 0.75f);
    ASSERT_GT(std::min({instance.tint.x, instance.tint.y, instance.tint.z}), 0.0f);
    const dvec2 away(static_cast<double>(p.x) - scene.camera.position->x,
                     static_cast<double>(p.z) - scene.camera.position->z);
    ASSERT_LE(glm::length(away), scene.vegetation.reach_m + 1.0);
  }
}

TEST_P(Biome, KeepsToItsRules) {
  const Surface surface(ground);
  const scene::Ground& rules = scene.biome.ground;
  for (const Instance& instance : growth.instances) {
    const vec3& p = instance.position;
    const float slope_cos = surface.at(static_cast<double>(p.x), static_cast<double>(p.z)).normal.y;
    const double slope_deg = static_cast<double>(degrees_from_radians(std::acos(slope_cos)));
    switch (species_of(instance)) {
      case Species::spruce:
      case Species::snowy_spruce:
        ASSERT_TRUE(GetParam() == BiomeKind::snow || GetParam() == BiomeKind::meadow);
        // Noise of amplitude 2.2 moves the limit by a quarter of its height for each unit.
        ASSERT_LT(static_cast<double>(p.y), rules.forest_top_m * 1.6);
        ASSERT_LT(slope_deg, rules.rock_slope_deg[1] + 20.0);
        break;
      case Species::larch:
      case Species::birch:
        ASSERT_EQ(GetParam(), BiomeKind::meadow);
        ASSERT_GT(static_cast<double>(p.y), scene.biome.water.level_m);
        ASSERT_LT(slope_deg, rules.rock_slope_deg[1] + 20.0);
        break;
      case Species::broadleaf:
        ASSERT_GT(static_cast<double>(p.y), scene.biome.water.level_m);
        break;
      case Species::palm:
        ASSERT_GT(static_cast<double>(p.y), scene.biome.water.level_m + 0.9);
        ASSERT_LT(p.y, 31.0f);
        break;
      case Species::driftwood:
        ASSERT_LT(p.y, 3.01f);
        ASSERT_LT(slope_deg, 14.1);
        break;
      case Species::tussock:
        ASSERT_TRUE(GetParam() == BiomeKind::sand || GetParam() == BiomeKind::meadow);
        ASSERT_LT(slope_deg, 35.1);
        break;
      case Species::scrub:
      case Species::acacia:
        ASSERT_EQ(GetParam(), BiomeKind::sand);
        ASSERT_LT(slope_deg, 18.1);
        break;
      case Species::boulder:
      case Species::snowy_boulder:
        ASSERT_LT(slope_deg, 42.1);
        break;
      default:
        break;
    }
  }
}

TEST_P(Biome, IsTheSameForAnyNumberOfThreads) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Growth again = scatter(test::resolved(scene), ground);
  EXPECT_EQ(again.models, growth.models);
  ASSERT_EQ(again.instances.size(), growth.instances.size());
  EXPECT_EQ(std::memcmp(again.instances.data(), growth.instances.data(),
                        growth.instances.size() * sizeof(Instance)),
            0);
}

TEST_P(Biome, GrowsTheSamePlantsWhereverTheCameraIs) {
  scene::Scene moved = scene;
  *moved.camera.position += dvec3(8.0, 0.0, -6.0);
  const Growth other = scatter(test::resolved(moved), ground);
  const auto before = [](const Instance& a, const Instance& b) {
    return std::tie(a.position.x, a.position.z, a.yaw_rad) <
           std::tie(b.position.x, b.position.z, b.yaw_rad);
  };
  std::vector<Instance> sorted = other.instances;
  std::sort(sorted.begin(), sorted.end(), before);
  std::size_t shared = 0;
  for (const Instance& instance : growth.instances) {
    shared += std::binary_search(sorted.begin(), sorted.end(), instance, before) ? 1 : 0;
  }
  EXPECT_GT(shared, growth.instances.size() * 9 / 10);
}

TEST_P(Biome, FollowsItsFields) {
  scene::Scene changed = scene;
  changed.vegetation.density = 0.5;
  const double half =
      static_cast<double>(scatter(test::resolved(changed), ground).instances.size());
  EXPECT_NEAR(half / static_cast<double>(growth.instances.size()), 0.5, 0.05);
  changed.vegetation = scene.vegetation;
  changed.vegetation.seed = 2;
  const Growth other = scatter(test::resolved(changed), ground);
  EXPECT_NE(other.instances[0].position, growth.instances[0].position);
  changed.vegetation.size = 2.0;
  changed.vegetation.seed = scene.vegetation.seed;
  EXPECT_FLOAT_EQ(scatter(test::resolved(changed), ground).instances[0].scale,
                  2.0f * growth.instances[0].scale);
  changed.vegetation.density = 0.0;
  EXPECT_TRUE(scatter(test::resolved(changed), ground).instances.empty());
  changed.vegetation.density = 1.0;
  changed.vegetation.enabled = false;
  EXPECT_TRUE(scatter(test::resolved(changed), ground).instances.empty());
}

TEST(Scatter, LeavesRoomForTheCameraAndEveryObstacle) {
  scene::Scene scene = scene::defaults(BiomeKind::snow, scene::View::outside);
  scene.terrain.cells = 4;
  scene.biome.ground.forest_share = 1.0;
  scene.biome.ground.forest_top_m = 1e5;
  scene.vegetation.reach_m = 400.0;
  scene.camera.position = {0.0, 103.0, 0.0};
  const mesh::GridMesh ground = mesh_over(4, 4000.0, [](double, double) { return 100.0; });
  std::vector<Obstacle> obstacles;
  const auto nearest = [&](double x, double z) {
    const vec3 to(static_cast<float>(x), 100.0f, static_cast<float>(z));
    float least = kInfinity;
    for (const Instance& i :
         scatter(test::resolved(scene), ground, Where::everywhere, obstacles).instances) {
      least = std::min(least, glm::distance(i.position, to));
    }
    return least;
  };
  EXPECT_GT(nearest(0.0, 0.0), 5.0f);
  EXPECT_LT(nearest(60.0, 0.0), 8.0f);
  EXPECT_LT(nearest(-60.0, 80.0), 8.0f);
  obstacles = {{{60.0, 100.0, 0.0}, 18.8}, {{-60.0, 100.0, 80.0}, 18.8}};
  EXPECT_GT(nearest(60.0, 0.0), 14.0f);
  EXPECT_GT(nearest(-60.0, 80.0), 14.0f);
  obstacles[1].position.y = 300.0;
  EXPECT_LT(nearest(-60.0, 80.0), 8.0f) << "high above the trees";
}

TEST(Scatter, NothingGrowsUnderWaterOrOnCliffs) {
  scene::Scene scene = scene::defaults(BiomeKind::tropical, scene::View::outside);
  scene.terrain.cells = 200;
  scene.vegetation.reach_m = 1000.0;
  // The ground is the sea, a beach, and a cliff of 70 degrees.
  const auto shore = [](double x, double) {
    return x < 300.0 ? 0.02 * x : 6.0 + 2.75 * (std::min(x, 500.0) - 300.0);
  };
  const mesh::GridMesh ground = mesh_over(200, 2000.0, shore);
  std::size_t on_beach = 0;
  for (const Instance& instance : scatter(test::resolved(scene), ground).instances) {
    ASSERT_GT(instance.position.y, -0.41f);
    const bool cliff = instance.position.x > 315.0f && instance.position.x < 485.0f;
    ASSERT_FALSE(cliff) << instance.position.x;
    on_beach += instance.position.x < 300.0f ? 1 : 0;
  }
  EXPECT_GT(on_beach, 500u);
}

TEST(Scatter, NothingStandsBeyondTheLand) {
  scene::Scene scene = scene::defaults(BiomeKind::snow, scene::View::outside);
  scene.terrain.cells = 4;
  scene.biome.ground.forest_share = 1.0;
  scene.biome.ground.forest_top_m = 1e5;
  scene.camera.position = {400.0, 500.0, 0.0};
  scene.balloon.enabled = false;
  const mesh::GridMesh ground = mesh_over(4, 1000.0, [](double, double) { return 100.0; });
  const Growth growth = scatter(test::resolved(scene), ground);
  EXPECT_GT(growth.instances.size(), 10000u);
  for (const Instance& instance : growth.instances) {
    ASSERT_LE(std::max(std::fabs(instance.position.x), std::fabs(instance.position.z)), 500.0f);
  }
}

TEST(Scatter, AxesAreATurnWithTheLeanAsked) {
  Instance instance;
  instance.yaw_rad = 0.7f;
  instance.scale = 2.0f;
  instance.lean = {0.3f, -0.2f};
  const Axes axes = axes_of(instance);
  EXPECT_NEAR(axes.y.x, 0.6f, 1e-6f);
  EXPECT_NEAR(axes.y.z, -0.4f, 1e-6f);
  for (const vec3& axis : {axes.x, axes.y, axes.z}) EXPECT_NEAR(glm::length(axis), 2.0f, 1e-5f);
  EXPECT_NEAR(glm::dot(axes.x, axes.y), 0.0f, 1e-5f);
  EXPECT_NEAR(glm::dot(axes.x, glm::cross(axes.y, axes.z)), 8.0f, 1e-4f);
  const Axes plain = axes_of({});
  EXPECT_EQ(plain.x, vec3(1, 0, 0));
  EXPECT_EQ(plain.y, vec3(0, 1, 0));
  EXPECT_EQ(plain.z, vec3(0, 0, 1));
}

TEST(Scatter, DetailFallsWithDistance) {
  Instance tree;
  const plant::ModelKey model{Species::spruce, 0};
  const scene::PixelSize pixel{1e-3,
                               0.0};  // 17 m are 120 pixels at 142 m, 30 at 567 m and 14 at 1214 m.
  EXPECT_EQ(detail_of(tree, model, {0.0, 0.0, 120.0}, pixel), plant::Detail::near);
  EXPECT_EQ(detail_of(tree, model, {0.0, 0.0, 200.0}, pixel), plant::Detail::middle);
  EXPECT_EQ(detail_of(tree, model, {0.0, 0.0, 650.0}, pixel), plant::Detail::far);
  EXPECT_EQ(detail_of(tree, model, {0.0, 0.0, 1300.0}, pixel), plant::Detail::outline);
  tree.scale = 2.0f;
  EXPECT_EQ(detail_of(tree, model, {0.0, 0.0, 200.0}, pixel), plant::Detail::near);
}

TEST(Scatter, DetailIsTheSameEverywhereInParallelViews) {
  const Instance tree;
  const plant::ModelKey model{Species::spruce, 0};
  for (const double distance : {1.0, 1000.0, 50000.0}) {
    const dvec3 eye(0.0, 0.0, distance);
    EXPECT_EQ(detail_of(tree, model, eye, {0.0, 0.1}), plant::Detail::near);
    EXPECT_EQ(detail_of(tree, model, eye, {0.0, 0.3}), plant::Detail::middle);
    EXPECT_EQ(detail_of(tree, model, eye, {0.0, 1.0}), plant::Detail::far);
    EXPECT_EQ(detail_of(tree, model, eye, {0.0, 2.0}), plant::Detail::outline);
  }
}

}  // namespace
}  // namespace aerostat::scatter
