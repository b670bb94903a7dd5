#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <tuple>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "core/error.hpp"
#include "terrain/fractal.hpp"
#include "terrain/height_field.hpp"
#include "terrain/terrain_mesh.hpp"

namespace aerostat::terrain {
namespace {

using scene::TerrainKind;

scene::Terrain small_terrain(TerrainKind kind, std::uint32_t seed = 1) {
  scene::Terrain terrain;
  terrain.kind = kind;
  terrain.seed = seed;
  terrain.cells = 160;
  terrain.size_m = kind == TerrainKind::mountains ? 40000.0 : 20000.0;
  terrain.height_m = kind == TerrainKind::mountains ? 2400.0 : 800.0;
  terrain.feature_m = kind == TerrainKind::mountains ? 9000.0 : 4000.0;
  return terrain;
}

const TerrainKind kKinds[] = {TerrainKind::mountains, TerrainKind::island, TerrainKind::dunes};

TEST(GradedAxis, SpansTheSizeSymmetricallyWithTheGradingAsked) {
  for (const int cells : {1, 2, 3, 64, 65})
    for (const double grading : {1.0, 6.0}) {
      const std::vector<double> axis = graded_axis(cells, 1000.0, grading);
      ASSERT_EQ(axis.size(), static_cast<std::size_t>(cells) + 1);
      EXPECT_EQ(axis.front(), -500.0);
      EXPECT_EQ(axis.back(), 500.0);
      for (int i = 0; i < cells; ++i) {
        EXPECT_LT(axis[i], axis[i + 1]);
        EXPECT_NEAR(axis[i], -axis[cells - i], 1e-9);
      }
      if (cells < 64) continue;
      const double rim = axis[1] - axis[0];
      const double middle = axis[cells / 2 + 1] - axis[cells / 2];
      EXPECT_NEAR(rim / middle, grading, 1e-6 * grading);
      for (int i = 1; i < cells; ++i) {
        const double ratio = (axis[i + 1] - axis[i]) / (axis[i] - axis[i - 1]);
        EXPECT_LT(std::max(ratio, 1.0 / ratio), 1.07);
      }
    }
}

TEST(GradedAxis, RefusesWhatCannotBeLaidOut) {
  EXPECT_THROW(graded_axis(0, 100.0, 1.0), Error);
  EXPECT_THROW(graded_axis(4, 0.0, 1.0), Error);
  EXPECT_THROW(graded_axis(4, 100.0, 0.5), Error);
}

TEST(Fractal, OctavesFollowLacunarityAndGain) {
  scene::Fractal fractal;
  fractal.octaves = 4;
  fractal.lacunarity = 2.5;
  fractal.gain = 0.4;
  const std::vector<Octave> octaves = make_octaves(fractal, 1000.0, 5u);
  ASSERT_EQ(octaves.size(), 4u);
  EXPECT_FLOAT_EQ(octaves[2].layer.wavelength_m, 160.0f);
  EXPECT_FLOAT_EQ(octaves[3].amplitude, 0.064f);
  EXPECT_NE(octaves[0].layer.seed, octaves[1].layer.seed);
}

TEST(Fractal, BandShareFollowsNyquist) {
  EXPECT_EQ(band_share(100.0f, 50.0f), 0.0f);
  EXPECT_EQ(band_share(100.0f, 25.0f), 1.0f);
  EXPECT_EQ(band_share(100.0f, 0.0f), 1.0f);
}

class EveryKind : public testing::TestWithParam<TerrainKind> {};
INSTANTIATE_TEST_SUITE_P(Terrain, EveryKind, testing::ValuesIn(kKinds));

TEST_P(EveryKind, MeshCoversTheSquareWithUpwardTriangles) {
  scene::Terrain terrain = small_terrain(GetParam());
  terrain.center = {500.0, -250.0};
  const mesh::TriangleMesh mesh = mesh::to_triangles(terrain_mesh(terrain));
  ASSERT_EQ(mesh.positions.size(), 161u * 161u);
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  ASSERT_EQ(mesh.triangles.size(), 2u * 160u * 160u);
  EXPECT_TRUE(mesh.colors.empty());
  EXPECT_FLOAT_EQ(mesh.positions.front().x, static_cast<float>(500.0 - 0.5 * terrain.size_m));
  EXPECT_FLOAT_EQ(mesh.positions.back().z, static_cast<float>(-250.0 + 0.5 * terrain.size_m));
  double area = 0.0;
  for (const uvec3& t : mesh.triangles) {
    const vec3 a = mesh.positions[t.x];
    const vec3 n = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
    ASSERT_GT(n.y, 0.0f);
    area += 0.5 * n.y;
  }
  EXPECT_NEAR(area / (terrain.size_m * terrain.size_m), 1.0, 1e-4);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    ASSERT_TRUE(is_finite(mesh.positions[i]) && is_finite(mesh.normals[i]));
    ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-5f);
    ASSERT_GT(mesh.normals[i].y, 0.0f);
  }
}

TEST_P(EveryKind, BitsDoNotDependOnTheNumberOfThreads) {
  const scene::Terrain terrain = small_terrain(GetParam(), 3);
  const auto build = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return mesh::to_triangles(terrain_mesh(terrain));
  };
  const mesh::TriangleMesh one = build(1);
  const mesh::TriangleMesh two = build(2);
  const auto same = [](const auto& a, const auto& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
  };
  EXPECT_TRUE(same(one.positions, two.positions));
  EXPECT_TRUE(same(one.normals, two.normals));
  EXPECT_TRUE(same(one.triangles, two.triangles));
}

TEST_P(EveryKind, NormalsFitTheTriangles) {
  const mesh::TriangleMesh mesh = mesh::to_triangles(terrain_mesh(small_terrain(GetParam())));
  mesh::TriangleMesh faceted = mesh;
  for (vec3& n : faceted.normals) n = vec3(0.0f);
  for (const uvec3& t : mesh.triangles) {
    const vec3 a = mesh.positions[t.x];
    const vec3 n = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
    for (int k = 0; k < 3; ++k) faceted.normals[t[k]] += n;
  }
  double angle = 0.0;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    angle +=
        std::acos(std::min(glm::dot(glm::normalize(faceted.normals[i]), mesh.normals[i]), 1.0f));
  EXPECT_LT(angle / static_cast<double>(mesh.normals.size()), 0.08);
}

TEST_P(EveryKind, FieldAgreesWithItselfOneByOneAndInBlocks) {
  const HeightField field(small_terrain(GetParam(), 2));
  Points points;
  points.count = kBlockSize;
  for (int i = 0; i < points.count; ++i) {
    points.x[i] = static_cast<float>(-6000 + 93 * i);
    points.z[i] = static_cast<float>(4100 - 71 * i);
    points.spacing[i] = 0.0f;
  }
  Block height;
  field.heights(points, height);
  for (int i = 0; i < points.count; ++i)
    EXPECT_EQ(height[i], static_cast<float>(field.height(points.x[i], points.z[i])));
}

TEST_P(EveryKind, NormalMatchesFiniteDifferences) {
  scene::Terrain terrain = small_terrain(GetParam());
  terrain.center = {1000.0, 2000.0};
  // The spacing rounds the ribs between gullies as it rounds dunes, so there is no erosion here.
  terrain.erosion = 0.0;
  const HeightField field(terrain);
  int different = 0;
  for (int i = 0; i < 200; ++i) {
    const double x = -3000.0 + 35.0 * i;
    const double z = 900.0 + 15.0 * i;
    const double e = 0.5;
    const vec3 n = field.normal(x, z, e);
    ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
    const double dx = (field.height(x + e, z) - field.height(x - e, z)) / (2 * e);
    const double dz = (field.height(x, z + e) - field.height(x, z - e)) / (2 * e);
    different += std::hypot(dx + n.x / n.y, dz + n.z / n.y) > 0.03 ? 1 : 0;
  }
  // The crests of dunes are rounded by the spacing that normal() gets, but heights are not.
  EXPECT_LE(different, GetParam() == TerrainKind::dunes ? 8 : 0);
}

TEST_P(EveryKind, SeedAndBaseMatter) {
  scene::Terrain terrain = small_terrain(GetParam());
  const HeightField one(terrain);
  terrain.base_m = 100.0;
  const HeightField raised(terrain);
  terrain.base_m = 0.0;
  terrain.seed = 99;
  const HeightField other(terrain);
  double difference = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double x = 200.0 * i - 4000.0;
    EXPECT_NEAR(raised.height(x, -2500.0) - one.height(x, -2500.0), 100.0, 1e-3);
    difference += std::fabs(other.height(x, -2500.0) - one.height(x, -2500.0));
  }
  EXPECT_GT(difference / 40.0, 1.0);
}

TEST_P(EveryKind, ACoarseReliefIsTheSameLandRoughly) {
  const scene::Terrain terrain = small_terrain(GetParam(), 3);
  const HeightField fine(terrain), coarse(terrain, Carving::coarse);
  double sum = 0.0, sum_of_fine = 0.0, most = 0.0;
  int count = 0;
  for (double x = -0.45; x < 0.46; x += 0.05)
    for (double z = -0.45; z < 0.46; z += 0.05, ++count) {
      const double height = fine.height(x * terrain.size_m, z * terrain.size_m);
      const double off = std::fabs(coarse.height(x * terrain.size_m, z * terrain.size_m) - height);
      sum += off;
      sum_of_fine += std::fabs(height);
      most = std::max(most, off);
    }
  RecordProperty("mean_off_m", std::to_string(sum / count));
  std::printf("off by %.0f m in the mean, %.0f m at most, of %.0f m\n", sum / count, most,
              sum_of_fine / count);
  if (GetParam() == TerrainKind::dunes) {
    EXPECT_EQ(most, 0.0) << "they are not carved";
  } else {
    EXPECT_GT(most, 0.0);
    EXPECT_LT(sum, 0.3 * sum_of_fine);
  }
}

TEST_P(EveryKind, ReliefDoesNotGoByTheMesh) {
  scene::Terrain terrain = small_terrain(GetParam());
  const float here = static_cast<float>(HeightField(terrain).height(310.0, -170.0));
  terrain.cells = 32;
  terrain.grading = 2.0;
  terrain.center = {100.0, 50.0};
  terrain.base_m = 500.0;
  EXPECT_EQ(static_cast<float>(HeightField(terrain).height(410.0, -120.0)), here + 500.0f);
}

// Tests cells at the centre that are 7 mm wide, although single precision has steps of up to 250 mm
// there.
TEST(TerrainMesh, KeepsFineCellsApartHoweverFarFromTheOrigin) {
  scene::Terrain terrain = small_terrain(TerrainKind::dunes);
  terrain.cells = 1024;
  terrain.size_m = 1000.0;
  terrain.grading = 1000.0;
  for (const dvec2& center : {dvec2(0.0, 0.0), dvec2(1e5, 1e5), dvec2(-2e6, 2e6)}) {
    terrain.center = center;
    const mesh::GridMesh mesh = terrain_mesh(terrain);
    EXPECT_NEAR(mesh.x(0), center.x - 500.0, 0.25);
    EXPECT_NEAR(mesh.z(1024), center.y + 500.0, 0.25);
  }
}

TEST(Mountains, HaveAFlatValleyAtTheCentreAndHighPeaks) {
  for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
    const scene::Terrain terrain = small_terrain(TerrainKind::mountains, seed);
    const mesh::TriangleMesh mesh = mesh::to_triangles(terrain_mesh(terrain));
    const double center = HeightField(terrain).height(0.0, 0.0);
    float highest = 0.0f;
    double steep = 0.0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const vec3& p = mesh.positions[i];
      if (std::hypot(p.x, p.z) < 12000.0f) highest = std::max(highest, p.y);
      steep += mesh.normals[i].y < 0.64f ? 1.0 : 0.0;
    }
    EXPECT_LT(center, 0.2 * terrain.height_m) << seed;
    EXPECT_GT(highest, 0.5 * terrain.height_m) << seed;
    EXPECT_LT(highest, 1.5 * terrain.height_m) << seed;
    EXPECT_LT(steep / static_cast<double>(mesh.positions.size()), 0.15) << seed;
  }
}

TEST(Dunes, SlipFacesLieAtTheAngleOfRepose) {
  scene::Terrain terrain = small_terrain(TerrainKind::dunes);
  const HeightField field(terrain);
  const double azimuth = terrain.dunes.wind_deg * 3.14159265358979 / 180.0;
  const double wx = std::sin(azimuth);
  const double wz = -std::cos(azimuth);
  std::vector<double> lee;
  std::vector<double> windward;
  for (int line = 0; line < 40; ++line)
    for (double s = -2500.0; s < 2500.0; s += 4.0) {
      const double x = wx * s - wz * 60.0 * (line - 20);
      const double z = wz * s + wx * 60.0 * (line - 20);
      const vec3 n = field.normal(x, z, 1.0);
      const double angle = std::acos(n.y) * 180.0 / 3.14159265358979;
      const bool faces_wind = n.x * wx + n.z * wz < 0.0;
      if (!faces_wind && angle > 28.0) lee.push_back(angle);
      if (faces_wind) windward.push_back(angle);
    }
  ASSERT_GT(lee.size(), 500u);
  std::nth_element(lee.begin(), lee.begin() + lee.size() / 2, lee.end());
  EXPECT_NEAR(lee[lee.size() / 2], 33.0, 1.5);
  std::nth_element(lee.begin(), lee.begin() + lee.size() * 95 / 100, lee.end());
  EXPECT_LT(lee[lee.size() * 95 / 100], 37.0);
  std::nth_element(windward.begin(), windward.begin() + windward.size() / 2, windward.end());
  EXPECT_GT(windward[windward.size() / 2], 4.0);
  EXPECT_LT(windward[windward.size() / 2], 18.0);
}

class Island : public testing::Test {
 protected:
  Island() {
    water_.enabled = true;
    const mesh::GridMesh ground = terrain_mesh(terrain_);
    ground_ = mesh::to_triangles(ground);
    sea_ = water_mesh(terrain_, water_, ground);
  }

  scene::Terrain terrain_ = small_terrain(TerrainKind::island);
  scene::Water water_;
  mesh::TriangleMesh ground_;
  mesh::TriangleMesh sea_;
};

TEST_F(Island, HasLandSeaAndAShallowLagoonNearTheCentre) {
  int land = 0;
  int lagoon = 0;
  float highest = 0.0f;
  for (const vec3& p : ground_.positions) {
    land += p.y > 0.0f ? 1 : 0;
    lagoon += p.y < 0.0f && p.y > -15.0f && std::hypot(p.x, p.z) < 3000.0f ? 1 : 0;
    highest = std::max(highest, p.y);
  }
  const auto count = static_cast<double>(ground_.positions.size());
  EXPECT_GT(land / count, 0.1);
  EXPECT_LT(land / count, 0.8);
  EXPECT_GT(lagoon / count, 0.005);
  EXPECT_GT(highest, 0.5 * terrain_.height_m);
}

TEST_F(Island, RimLiesInDeepWater) {
  const std::size_t side = static_cast<std::size_t>(terrain_.cells) + 1;
  for (std::size_t i = 0; i < side; ++i) {
    EXPECT_LT(ground_.positions[i].y, -20.0f);
    EXPECT_LT(ground_.positions[i * side].y, -20.0f);
    EXPECT_LT(ground_.positions[ground_.positions.size() - 1 - i].y, -20.0f);
  }
}

TEST_F(Island, SeaIsALevelSheetWithTheDepthOfTheGround) {
  std::map<std::pair<float, float>, float> heights;
  for (const vec3& p : ground_.positions) heights[{p.x, p.z}] = p.y;
  ASSERT_EQ(sea_.colors.size(), sea_.positions.size());
  ASSERT_EQ(sea_.normals.size(), sea_.positions.size());
  std::size_t inside = 0;
  for (std::size_t i = 0; i < sea_.positions.size(); ++i) {
    EXPECT_EQ(sea_.positions[i].y, 0.0f);
    EXPECT_EQ(sea_.normals[i], vec3(0.0f, 1.0f, 0.0f));
    EXPECT_GE(sea_.colors[i].x, 0.0f);
    const auto ground = heights.find({sea_.positions[i].x, sea_.positions[i].z});
    if (ground == heights.end()) continue;
    EXPECT_FLOAT_EQ(sea_.colors[i].x, std::max(-ground->second, 0.0f));
    ++inside;
  }
  EXPECT_GT(inside, 1000u);
}

TEST_F(Island, SeaCoversAllWetGroundAndReachesTheHorizonWithoutACrack) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double area = 0.0;
  float reach = 0.0f;
  for (const uvec3& t : sea_.triangles) {
    const vec3 a = sea_.positions[t.x];
    const vec3 n = glm::cross(sea_.positions[t.y] - a, sea_.positions[t.z] - a);
    ASSERT_GT(n.y, 0.0f);
    area += 0.5 * n.y;
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  int open_far = 0;
  for (const auto& [edge, uses] : edges) {
    ASSERT_EQ(uses, 1);
    if (edges.contains({edge.second, edge.first})) continue;
    const vec3 p = sea_.positions[edge.first];
    const float far = std::max(std::fabs(p.x), std::fabs(p.z));
    reach = std::max(reach, far);
    if (far > 9900.0f) {
      EXPECT_NEAR(far, 100000.0f, 1.0f);
      ++open_far;
    }
  }
  EXPECT_EQ(open_far, 4 * terrain_.cells);
  double dry = 0.0;
  for (std::size_t i = 0; i < ground_.triangles.size(); i += 2) {
    bool wet = false;
    for (int k = 0; k < 6; ++k) {
      const uvec3& t = ground_.triangles[i + k / 3];
      wet = wet || ground_.positions[t[k % 3]].y <= 0.5f;
    }
    for (int k = 0; !wet && k < 2; ++k) {
      const uvec3& t = ground_.triangles[i + k];
      const vec3 a = ground_.positions[t.x];
      dry += 0.5 * glm::cross(ground_.positions[t.y] - a, ground_.positions[t.z] - a).y;
    }
  }
  EXPECT_NEAR((area + dry) / 4e10, 1.0, 1e-4);
}

TEST_F(Island, NoWaterIsAnEmptyMesh) {
  water_.enabled = false;
  EXPECT_TRUE(water_mesh(terrain_, water_, terrain_mesh(terrain_)).empty());
}

}  // namespace
}  // namespace aerostat::terrain
