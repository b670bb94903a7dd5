// Tests glTF files that are written: read again, they hold the same model.
#include "asset/write_gltf.hpp"

#include <string>
#include <string_view>

#include "support.hpp"

namespace aerostat::asset {
namespace {

/// A triangle with all attributes in two places, and a flat one in one place.
Model sample() {
  Primitive full;
  full.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  full.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  full.uv = {{0, 1}, {1, 1}, {0, 0}};
  full.colors = {{1, 0.5f, 0.25f, 1}, {1, 1, 1, 1}, {0, 0, 0, 0.5f}};
  full.triangles = {{0, 1, 2}};
  full.material = 1;
  Primitive bare;
  bare.positions = {{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {2, 0, 2}};
  bare.triangles = {{0, 1, 2}, {1, 3, 2}};
  Model model;
  model.meshes = {{"a \"name\"", {full}}, {"bare", {bare}}};
  glm::dmat4 moved(1.0);
  moved[3] = {5.0, 6.0, 7.0, 1.0};
  glm::dmat4 turned(0.0);
  turned[0] = {0.0, 0.0, -2.0, 0.0};
  turned[1] = {0.0, 2.0, 0.0, 0.0};
  turned[2] = {2.0, 0.0, 0.0, 0.0};
  turned[3] = {-3.0, 0.25, 0.0, 1.0};
  model.placements = {{0, moved}, {0, turned}, {1, glm::dmat4(1.0)}};
  model.materials.resize(2);
  Material& material = model.materials[1];
  material.name = "paint";
  material.base_color = {0.5f, 0.25f, 0.125f, 0.75f};
  material.metallic = 0.5f;
  material.roughness = 0.25f;
  material.emission = {4.0f, 2.0f, 1.0f};
  material.alpha = AlphaMode::mask;
  material.alpha_cutoff = 0.3f;
  material.double_sided = true;
  material.transmission = 0.4f;
  material.ior = 1.33f;
  material.normal_scale = 0.5f;
  TextureUse use;
  use.wrap_u = Wrap::mirror;
  use.wrap_v = Wrap::clamp;
  material.base_color_texture = use;
  use.texture = 1;
  use.nearest = true;
  material.normal_texture = use;
  model.textures = {{"paint", 2, 1, {255, 0, 0, 255, 0, 255, 0, 128}},
                    {"bumps", 1, 1, {128, 128, 255, 255}}};
  return model;
}

void expect_sample(const Model& read) {
  const Model model = sample();
  ASSERT_EQ(placed_triangle_count(read), 4u);
  ASSERT_EQ(read.meshes.size(), 2u) << "the mesh that stands twice is there once";
  ASSERT_EQ(read.placements.size(), 3u);
  EXPECT_EQ(read.meshes[0].name, "a \"name\"");
  const Bounds box = bounds(read), expected = bounds(model);
  EXPECT_LT(glm::distance(box.least + read.origin, expected.least + model.origin), 1e-6);
  EXPECT_LT(glm::distance(box.most + read.origin, expected.most + model.origin), 1e-6);
  for (std::size_t i = 0; i < 3; ++i) {
    for (int c = 0; c < 4; ++c) {
      EXPECT_LT(glm::distance(read.placements[i].transform[c], model.placements[i].transform[c]),
                1e-6);
    }
  }
  const Primitive &a = first_of(read), &b = first_of(model);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.uv, b.uv);
  EXPECT_EQ(a.colors, b.colors);
  EXPECT_EQ(a.triangles, b.triangles);
  const Material &m = read.materials.at(a.material), &n = model.materials[1];
  EXPECT_EQ(m.name, n.name);
  EXPECT_EQ(m.base_color, n.base_color);
  EXPECT_EQ(m.metallic, n.metallic);
  EXPECT_EQ(m.roughness, n.roughness);
  EXPECT_LT(glm::distance(m.emission, n.emission), 1e-6f);
  EXPECT_EQ(m.alpha, n.alpha);
  EXPECT_EQ(m.alpha_cutoff, n.alpha_cutoff);
  EXPECT_TRUE(m.double_sided);
  EXPECT_EQ(m.transmission, n.transmission);
  EXPECT_EQ(m.ior, n.ior);
  EXPECT_EQ(m.normal_scale, n.normal_scale);
  ASSERT_TRUE(m.base_color_texture && m.normal_texture);
  EXPECT_EQ(m.base_color_texture->wrap_u, Wrap::mirror);
  EXPECT_EQ(m.base_color_texture->wrap_v, Wrap::clamp);
  EXPECT_TRUE(m.normal_texture->nearest);
  EXPECT_EQ(read.textures.at(m.base_color_texture->texture).rgba, model.textures[0].rgba);
  EXPECT_EQ(read.textures.at(m.normal_texture->texture).rgba, model.textures[1].rgba);
}

std::string text_of(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

TEST(WriteGltf, GlbIsReadAgain) {
  const Model read = read_text(text_of(glb_bytes(sample())), Format::gltf);
  EXPECT_EQ(all_notes(read), "");
  expect_sample(read);
}

TEST(WriteGltf, GltfHasItsBufferBesideIt) {
  const Folder folder;
  const GltfParts parts = gltf_parts(sample(), "world.bin");
  folder.write("world.bin", text_of(parts.binary));
  expect_sample(read(folder.write("world.gltf", parts.json)));
}

/// Positions keep their precision far from zero, because the origin is a node's.
TEST(WriteGltf, TheOriginMovesAll) {
  Model model = sample();
  model.origin = {500'000.25, 100.0, -4'000'000.5};
  const Model read = read_text(text_of(glb_bytes(model)), Format::gltf);
  const glm::dvec3 expected = model.origin + bounds(model).least;
  EXPECT_LT(glm::distance(read.origin + bounds(read).least, expected), 1e-6);
}

TEST(WriteGltf, MeshesWithoutTrianglesAreLeftOut) {
  Model model = sample();
  model.meshes[0].primitives[0].triangles.clear();
  const Model read = read_text(text_of(glb_bytes(model)), Format::gltf);
  EXPECT_EQ(read.meshes.size(), 1u);
  EXPECT_EQ(read.placements.size(), 1u);
}

}  // namespace
}  // namespace aerostat::asset
