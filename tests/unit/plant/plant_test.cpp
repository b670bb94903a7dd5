// Tests that the levels of detail of plants agree, and that their meshes meet the needs of the
// renderer.
#include "plant/plant.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "plant/outline.hpp"
#include "plant/random.hpp"
#include "support/mesh_checks.hpp"

namespace aerostat::plant {
namespace {

constexpr Detail kDetails[4] = {Detail::near, Detail::middle, Detail::far, Detail::outline};

std::vector<ModelKey> all_models() {
  std::vector<ModelKey> models;
  for (int s = 0; s < kSpeciesCount; ++s) {
    const auto species = static_cast<Species>(s);
    for (int v = 0; v < variant_count(species); ++v) models.push_back({species, v});
  }
  return models;
}

class PlantModel : public testing::TestWithParam<ModelKey> {};

std::string name_of(const testing::TestParamInfo<ModelKey>& info) {
  return std::string(species_name(info.param.species)) + std::to_string(info.param.variant);
}

INSTANTIATE_TEST_SUITE_P(Every, PlantModel, testing::ValuesIn(all_models()), name_of);

struct Extent {
  vec3 least{kInfinity}, most{-kInfinity};
};

Extent extent_of(const mesh::TriangleMesh& mesh) {
  Extent extent;
  for (const vec3& p : mesh.positions) {
    extent.least = glm::min(extent.least, p);
    extent.most = glm::max(extent.most, p);
  }
  return extent;
}

TEST_P(PlantModel, IsAWellFormedMesh) {
  for (const Detail detail : kDetails) {
    const mesh::TriangleMesh mesh = build(GetParam(), detail);
    ASSERT_NO_THROW(mesh::check(mesh, "plant"));
    ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      ASSERT_TRUE(is_finite(mesh.positions[i]));
      ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-5f);
      const vec3& color = mesh.colors[i];
      ASSERT_GE(std::min({color.x, color.y, color.z}), 0.0f);
      ASSERT_LE(std::max({color.x, color.y, color.z}), 0.9f);
    }
    for (const uvec3& t : mesh.triangles) ASSERT_GT(test::area(mesh, t), 1e-9);
  }
}

TEST_P(PlantModel, StandsOnTheGroundAndIsAsHighAsItSays) {
  for (const Detail detail : kDetails) {
    const Extent extent = extent_of(build(GetParam(), detail));
    EXPECT_NEAR(static_cast<double>(extent.most.y), model_height(GetParam()), 1e-4);
    EXPECT_LE(extent.least.y, 0.0f);
    EXPECT_GT(extent.least.y, -1.0f);
    EXPECT_LT(std::fabs(extent.least.x + extent.most.x), 1.2f * (extent.most.x - extent.least.x));
  }
}

TEST_P(PlantModel, TakesTheTrianglesOfItsLevel) {
  const std::size_t most[3] = {20000, 2000, 250}, least[3] = {400, 80, 40};
  std::size_t before = SIZE_MAX;
  for (int level = 0; level < 3; ++level) {
    const std::size_t count = build(GetParam(), kDetails[level]).triangles.size();
    EXPECT_LE(count, most[level]) << level;
    EXPECT_GE(count, least[level]) << level;
    EXPECT_LT(2 * count, before);
    before = count;
  }
  const std::size_t outline = build(GetParam(), Detail::outline).triangles.size();
  EXPECT_TRUE(outline == before || (outline == kOutlineTriangles && outline < before)) << outline;
}

/// The share of a square grid of rays along +-z that a mesh covers, and the mean colour there.
struct Silhouette {
  double share = 0.0;
  vec3 color{0.0f};
};

/// Marks the cells whose middle lies in a triangle, and keeps the colour nearest to the eye.
Silhouette silhouette(const mesh::TriangleMesh& mesh, double yaw, double width) {
  constexpr int kCells = 96;
  const auto c = static_cast<float>(std::cos(yaw)), s = static_cast<float>(std::sin(yaw));
  const float cell = static_cast<float>(width) / kCells;
  std::vector<float> depth(kCells * kCells, -kInfinity);
  std::vector<vec3> seen(depth.size());
  const auto place = [&](const vec3& p) {
    return vec3((c * p.x + s * p.z) / cell + 0.5f * kCells, p.y / cell, c * p.z - s * p.x);
  };
  for (const uvec3& t : mesh.triangles) {
    const vec3 p[3] = {place(mesh.positions[t.x]), place(mesh.positions[t.y]),
                       place(mesh.positions[t.z])};
    const float area =
        (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (area == 0.0f) continue;
    const vec3 low = glm::min(p[0], glm::min(p[1], p[2])),
               high = glm::max(p[0], glm::max(p[1], p[2]));
    for (int j = std::max(static_cast<int>(low.y), 0);
         j < std::min<int>(static_cast<int>(high.y) + 1, kCells); ++j) {
      for (int i = std::max(static_cast<int>(low.x), 0);
           i < std::min<int>(static_cast<int>(high.x) + 1, kCells); ++i) {
        const float x = static_cast<float>(i) + 0.5f, y = static_cast<float>(j) + 0.5f;
        const float u =
            ((x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (y - p[0].y)) / area;
        const float v =
            ((p[1].x - p[0].x) * (y - p[0].y) - (x - p[0].x) * (p[1].y - p[0].y)) / area;
        if (u < 0.0f || v < 0.0f || u + v > 1.0f) continue;
        const float z = (1.0f - u - v) * p[0].z + u * p[1].z + v * p[2].z;
        const auto at = static_cast<std::size_t>(j * kCells + i);
        if (z <= depth[at]) continue;
        depth[at] = z;
        seen[at] = (1.0f - u - v) * mesh.colors[t.x] + u * mesh.colors[t.y] + v * mesh.colors[t.z];
      }
    }
  }
  Silhouette result;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] == -kInfinity) continue;
    result.share += 1.0 / static_cast<double>(depth.size());
    result.color += seen[i];
  }
  result.color /= static_cast<float>(result.share * static_cast<double>(depth.size()));
  return result;
}

Silhouette mean_silhouette(const ModelKey& model, Detail detail, double width) {
  const mesh::TriangleMesh mesh = build(model, detail);
  Silhouette mean;
  for (const double yaw : {0.0, 0.9, 2.2, 4.0}) {
    const Silhouette one = silhouette(mesh, yaw, width);
    mean.share += 0.25 * one.share;
    mean.color += 0.25f * one.color;
  }
  return mean;
}

TEST_P(PlantModel, KeepsItsSilhouetteAndColourAcrossTheLevels) {
  const double width = 1.6 * model_height(GetParam());
  const Silhouette near = mean_silhouette(GetParam(), Detail::near, width);
  EXPECT_GT(near.share, 0.02);
  for (const Detail detail : {Detail::middle, Detail::far, Detail::outline}) {
    const Silhouette other = mean_silhouette(GetParam(), detail, width);
    const double tolerance = detail == Detail::middle ? 0.25 : 0.35;
    EXPECT_NEAR(other.share / near.share, 1.0, tolerance) << static_cast<int>(detail);
    EXPECT_NEAR(
        static_cast<double>((other.color.y + other.color.x) / (near.color.y + near.color.x)), 1.0,
        tolerance)
        << static_cast<int>(detail);
  }
}

TEST_P(PlantModel, IsTheSameEveryTime) {
  for (const Detail detail : kDetails) {
    const mesh::TriangleMesh a = build(GetParam(), detail), b = build(GetParam(), detail);
    ASSERT_EQ(a.positions.size(), b.positions.size());
    EXPECT_EQ(
        std::memcmp(a.positions.data(), b.positions.data(), a.positions.size() * sizeof(vec3)), 0);
    EXPECT_EQ(std::memcmp(a.normals.data(), b.normals.data(), a.normals.size() * sizeof(vec3)), 0);
    EXPECT_EQ(std::memcmp(a.colors.data(), b.colors.data(), a.colors.size() * sizeof(vec3)), 0);
    EXPECT_EQ(a.triangles, b.triangles);
  }
}

TEST(Plant, VariantsDifferAndOthersDoNotExist) {
  for (int s = 0; s < kSpeciesCount; ++s) {
    const auto species = static_cast<Species>(s);
    for (int v = 1; v < variant_count(species); ++v) {
      EXPECT_NE(build({species, v}, Detail::far).positions,
                build({species, 0}, Detail::far).positions);
    }
    EXPECT_THROW(build({species, variant_count(species)}, Detail::far), Error);
    EXPECT_THROW(build({species, -1}, Detail::far), Error);
  }
}

bool has_outline(const ModelKey& model) {
  return build(model, Detail::outline).triangles.size() == kOutlineTriangles;
}

/// Tests that an outline is as wide and as bright as the model that it stands for, more closely
/// than levels made by hand are.
TEST(Plant, OutlinesCoverWhatTheirPlantsCover) {
  for (const ModelKey& model : all_models()) {
    const double width = 1.6 * model_height(model);
    const Silhouette plant = mean_silhouette(model, Detail::far, width);
    const Silhouette outline = mean_silhouette(model, Detail::outline, width);
    EXPECT_NEAR(outline.share / plant.share, 1.0, 0.15) << species_name(model.species);
    for (int c = 0; c < 3; ++c) {
      // The colour of an outline has the shade that its leaves would cast on each other.
      const float shade = has_outline(model) ? 0.78f : 1.0f;
      EXPECT_NEAR(outline.color[c] / plant.color[c], shade, 0.12f) << species_name(model.species);
    }
  }
}

TEST(Plant, OutlinesTurnOutwards) {
  const mesh::TriangleMesh mesh = build({Species::spruce, 0}, Detail::outline);
  EXPECT_GT(test::worst_normal(mesh), 0.0);
  EXPECT_EQ(test::count_edges(mesh).crowded, 0u);
  EXPECT_EQ(test::count_edges(mesh).open, 6u) << "the ring at the foot";
}

TEST(Plant, BouldersAreClosedAndTurnOutwards) {
  for (const Detail detail : kDetails) {
    const mesh::TriangleMesh mesh = build({Species::boulder, 0}, detail);
    EXPECT_EQ(test::count_edges(mesh).open, 0u);
    EXPECT_EQ(test::count_edges(mesh).crowded, 0u);
    EXPECT_GT(test::volume(mesh), 0.3);
    EXPECT_GT(test::worst_normal(mesh), 0.0);
  }
}

/// Returns the mean colour of the brighter quarter of the green vertices, because the inside of a
/// crown is darker.
vec3 brightest_mean(const ModelKey& model) {
  const mesh::TriangleMesh mesh = build(model, Detail::near);
  std::vector<vec3> colors = mesh.colors;
  std::erase_if(colors, [](const vec3& c) { return c.y <= c.x; });
  std::sort(colors.begin(), colors.end(), [](const vec3& a, const vec3& b) { return a.y > b.y; });
  vec3 sum(0.0f);
  for (std::size_t i = 0; i < colors.size() / 4; ++i) sum += colors[i];
  return sum / static_cast<float>(colors.size() / 4);
}

TEST(Plant, AlbedoIsWithinMeasuredRanges) {
  const vec3 conifer = brightest_mean({Species::spruce, 0});
  EXPECT_GT(conifer.y, conifer.x);
  EXPECT_GT(conifer.y, 0.04f);
  EXPECT_LT(conifer.y, 0.12f);
  for (const Species species : {Species::broadleaf, Species::palm, Species::shrub}) {
    const vec3 leaf = brightest_mean({species, 0});
    EXPECT_GT(leaf.y, 1.2f * leaf.x) << species_name(species);
    EXPECT_GT(leaf.y, 0.05f) << species_name(species);
    EXPECT_LT(leaf.y, 0.2f) << species_name(species);
  }
  const mesh::TriangleMesh snowy = build({Species::snowy_spruce, 0}, Detail::near);
  EXPECT_GT(std::max_element(snowy.colors.begin(), snowy.colors.end(),
                             [](auto& a, auto& b) { return a.x < b.x; })
                ->x,
            0.7f);
}

TEST(Plant, CrownsAreDarkWithinAndNormalsTurnOutwards) {
  const mesh::TriangleMesh tree = build({Species::broadleaf, 2}, Detail::near);
  const vec3 middle(0.0f, 6.6f, 0.0f);
  double inner = 0.0, outer = 0.0, outwards = 0.0;
  int inners = 0, outers = 0;
  for (std::size_t i = 0; i < tree.positions.size(); ++i) {
    const vec3 from = tree.positions[i] - middle;
    const float distance = glm::length(from);
    const bool green = tree.colors[i].y > 1.2f * tree.colors[i].x;
    if (!green) continue;
    if (distance < 2.6f) inner += static_cast<double>(tree.colors[i].y), ++inners;
    if (distance < 4.0f) continue;
    outer += static_cast<double>(tree.colors[i].y), ++outers;
    outwards += static_cast<double>(glm::dot(from / distance, tree.normals[i]));
  }
  ASSERT_GT(inners, 50);
  ASSERT_GT(outers, 500);
  EXPECT_LT(inner / inners, 0.7 * outer / outers);
  EXPECT_GT(outwards / outers, 0.7);
}

TEST(PlantRandom, IsEvenAndRepeats) {
  Random a(7), b(7);
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double u = a.unit();
    ASSERT_EQ(u, b.unit());
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  // The tolerances are five standard deviations of the mean of 20000 evenly distributed numbers.
  EXPECT_NEAR(sum / 20000, 0.5, 5 * 0.2887 / std::sqrt(20000.0));
  EXPECT_NEAR(squares / 20000, 1.0 / 3.0, 5 * 0.2981 / std::sqrt(20000.0));
}

}  // namespace
}  // namespace aerostat::plant
