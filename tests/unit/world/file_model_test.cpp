// Tests how models from files are put together and where they stand.
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "world/scene_models.hpp"

namespace aerostat::world {
namespace {

/// A right-angled triangle in the plane of x and y, whose normal is +z.
asset::Primitive corner_piece() {
  asset::Primitive primitive;
  primitive.positions = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}};
  primitive.triangles = {{0, 1, 2}};
  return primitive;
}

asset::Model model_of(asset::Primitive primitive, const glm::dmat4& transform = glm::dmat4(1.0)) {
  asset::Model model;
  model.materials.resize(primitive.material + 1);
  model.meshes.push_back({"mesh", {std::move(primitive)}});
  model.placements.push_back({0, transform});
  return model;
}

glm::dmat4 scaling(const dvec3& factors) {
  glm::dmat4 matrix(1.0);
  for (int i = 0; i < 3; ++i) matrix[i][i] = factors[i];
  return matrix;
}

FileModel made(asset::Model model) {
  return file_model({"folder/house.glb", {}}, std::move(model));
}

vec3 plane_normal(const mesh::TriangleMesh& mesh, std::size_t i = 0) {
  const uvec3 t = mesh.triangles[i];
  return glm::normalize(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                   mesh.positions[t.z] - mesh.positions[t.x]));
}

TEST(FileModel, StandsOnItsLowestPointInTheMiddleOfItsBox) {
  asset::Primitive primitive = corner_piece();
  for (vec3& position : primitive.positions) position += vec3(100.0f, -7.0f, 30.0f);
  const FileModel model = made(model_of(primitive));
  const auto& mesh = model.parts->front().mesh;
  EXPECT_EQ(mesh.positions[0], vec3(-1, 0, 0));
  EXPECT_EQ(mesh.positions[1], vec3(1, 0, 0));
  EXPECT_EQ(mesh.positions[2], vec3(-1, 4, 0));
  EXPECT_EQ(model.size, dvec3(2, 4, 0));
  EXPECT_EQ(model.triangles, 1u);
  EXPECT_EQ(model.base_least, dvec2(-1, 0)) << "what is more than 2 % of the height up";
  EXPECT_EQ(model.base_most, dvec2(1, 0));
}

TEST(FileModel, TrianglesWithoutNormalsAreFlat) {
  asset::Primitive primitive = corner_piece();
  primitive.positions.emplace_back(0, 0, 3);
  primitive.triangles.push_back({0, 3, 1});
  primitive.uv = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  const FileModel model = made(model_of(primitive));
  const auto& mesh = model.parts->front().mesh;
  ASSERT_EQ(mesh.positions.size(), 6u) << "no vertex is shared";
  for (std::size_t i = 0; i < 2; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      EXPECT_LT(glm::distance(mesh.normals[mesh.triangles[i][corner]], plane_normal(mesh, i)),
                1e-6f);
    }
  }
  EXPECT_EQ(mesh.uvs[mesh.triangles[1].y], vec2(1, 1));
}

TEST(FileModel, MirroredMeshesKeepTheirFrontSide) {
  asset::Primitive primitive = corner_piece();
  primitive.normals.assign(3, vec3(0, 0, 1));
  const FileModel mirrored = made(model_of(primitive, scaling({-1, 1, 1})));
  const auto& mesh = mirrored.parts->front().mesh;
  EXPECT_LT(glm::distance(plane_normal(mesh), vec3(0, 0, 1)), 1e-6f);
  EXPECT_LT(glm::distance(mesh.normals[0], vec3(0, 0, 1)), 1e-6f);
  const FileModel turned = made(model_of(primitive, scaling({1, 1, -1})));
  EXPECT_LT(glm::distance(plane_normal(turned.parts->front().mesh), vec3(0, 0, -1)), 1e-6f);
  EXPECT_LT(glm::distance(turned.parts->front().mesh.normals[0], vec3(0, 0, -1)), 1e-6f);
}

TEST(FileModel, NormalsOfStretchedMeshesStayPerpendicular) {
  asset::Primitive primitive;
  primitive.positions = {{0, 0, 0}, {1, 1, 0}, {0, 0, 1}};
  primitive.normals.assign(3, glm::normalize(vec3(1, -1, 0)));
  primitive.triangles = {{0, 1, 2}};
  const FileModel model = made(model_of(primitive, scaling({5, 1, 2})));
  const auto& mesh = model.parts->front().mesh;
  EXPECT_NEAR(std::abs(glm::dot(mesh.normals[0], plane_normal(mesh))), 1.0f, 1e-6f);
  EXPECT_GT(mesh.normals[0].x, 0.0f);
  EXPECT_LT(mesh.normals[0].y, 0.0f);
}

TEST(FileModel, HasOneMeshForEachMaterialThatIsUsed) {
  asset::Model model = model_of(corner_piece());
  model.materials.resize(3);
  asset::Primitive other = corner_piece();
  other.material = 2;
  model.meshes[0].primitives.push_back(other);
  model.placements.push_back({0, scaling({2, 2, 2})});
  const FileModel merged = made(std::move(model));
  ASSERT_EQ(merged.parts->size(), 2u);
  EXPECT_EQ((*merged.parts)[0].file_material, 0u);
  EXPECT_EQ((*merged.parts)[1].file_material, 2u);
  EXPECT_EQ((*merged.parts)[1].mesh.triangles.size(), 2u);
  EXPECT_EQ(merged.materials.size(), 3u);
  EXPECT_EQ(merged.triangles, 4u);
}

TEST(FileModel, NeedsTriangles) {
  try {
    made({});
    FAIL() << "expected an error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_data);
    EXPECT_EQ(std::string(error.what()),
              "folder/house.glb: found no triangles, expected a surface");
  }
}

TEST(FileModel, SizesAreTold) {
  FileModel model = made(model_of(corner_piece()));
  model.triangles = 1234567;
  scene::PlacedModel placed;
  EXPECT_EQ(size_note(placed, model),
            "house.glb: 2.0 x 4.0 x 0 m (width, height, depth), 1,234,567 triangles.");
  placed.height_m = 100.0;
  EXPECT_EQ(scale_of(placed, model), 25.0);
  EXPECT_EQ(size_note(placed, model),
            "house.glb: 50.0 x 100 x 0 m (width, height, depth), 1,234,567 triangles.");
  placed.height_m.reset();
  placed.scale = 0.001;
  EXPECT_NE(size_note(placed, model).find("That is less than 1 cm: \"height_m\" sets"),
            std::string::npos);
  placed.scale = 3000.0;
  EXPECT_NE(size_note(placed, model).find("That is more than 10 km"), std::string::npos);
}

}  // namespace
}  // namespace aerostat::world
