#include <string>

#include "gltf_builder.hpp"
#include "support.hpp"

namespace aerostat::asset {
namespace {

/// Returns a file with a material, two textures of one picture, and two sets of texture
/// coordinates.
std::string with_material(const std::string& material, const std::string& more = {}) {
  GltfBuilder builder;
  builder.square()
      .floats("VEC2", 4, {0.25, 0.5, 0, 0, 0, 0, 0, 0})
      .floats("VEC2", 4, {0.75, 1, 0, 0, 0, 0, 0, 0})
      .view(png_2x1());
  return builder.text(
      R"("images":[{"bufferView":3,"mimeType":"image/png"},{"uri":"none.png"}],)"
      R"("samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728}],)"
      R"("textures":[{"source":0,"sampler":0},{"source":0},{"source":1},)"
      R"({"extensions":{"KHR_texture_basisu":{"source":0}}}],"materials":[{)" +
      material + "}]," +
      one_mesh(
          R"("attributes":{"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_1":2},"mode":5,"material":0)") +
      more);
}

Model read_material(const std::string& material) {
  return read_text(with_material(material), Format::gltf);
}

std::string material_message(const std::string& material) {
  return message_of(with_material(material), Format::gltf);
}

TEST(AssetGltfMaterials, NumbersAndTheirDefaultsAreRead) {
  const Material standard = read_material("").materials.at(0);
  EXPECT_EQ(standard.base_color, glm::vec4(1.0f));
  EXPECT_FLOAT_EQ(standard.metallic, 1.0f);
  EXPECT_FLOAT_EQ(standard.roughness, 1.0f);
  EXPECT_FALSE(standard.double_sided);
  EXPECT_EQ(standard.alpha, AlphaMode::opaque);
  const Material full =
      read_material(
          R"("name":"m","doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.25,)"
          R"("emissiveFactor":[1,0.5,0],"pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],)"
          R"("metallicFactor":0.5,"roughnessFactor":0.75},"extensions":{)"
          R"("KHR_materials_emissive_strength":{"emissiveStrength":4},)"
          R"("KHR_materials_ior":{"ior":1.33},"KHR_materials_transmission":{"transmissionFactor":0.5}})")
          .materials.at(0);
  EXPECT_EQ(full.name, "m");
  EXPECT_EQ(full.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(full.emission, glm::vec3(4.0f, 2.0f, 0.0f));
  EXPECT_EQ(full.alpha, AlphaMode::mask);
  EXPECT_FLOAT_EQ(full.alpha_cutoff, 0.25f);
  EXPECT_FLOAT_EQ(full.metallic, 0.5f);
  EXPECT_FLOAT_EQ(full.roughness, 0.75f);
  EXPECT_FLOAT_EQ(full.ior, 1.33f);
  EXPECT_FLOAT_EQ(full.transmission, 0.5f);
  EXPECT_TRUE(full.double_sided);
  EXPECT_EQ(read_material(R"("alphaMode":"BLEND")").materials.at(0).alpha, AlphaMode::blend);
}

TEST(AssetGltfMaterials, ColoursWithoutLightBecomeMatt) {
  const Material unlit =
      read_material(R"("extensions":{"KHR_materials_unlit":{}},"emissiveFactor":[0,0,0])")
          .materials.at(0);
  EXPECT_FLOAT_EQ(unlit.metallic, 0.0f);
  EXPECT_FLOAT_EQ(unlit.roughness, 1.0f);
  EXPECT_EQ(unlit.emission, glm::vec3(0.0f));
  const Material older =
      read_material(
          R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[1,0,0,1],)"
          R"("glossinessFactor":0.25}})")
          .materials.at(0);
  EXPECT_EQ(older.base_color, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
  EXPECT_FLOAT_EQ(older.roughness, 0.75f);
  EXPECT_FLOAT_EQ(older.metallic, 0.0f);
}

TEST(AssetGltfMaterials, TexturesHaveSamplersAndAreDecodedOnce) {
  const Model model = read_material(
      R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1}},)"
      R"("normalTexture":{"index":1,"scale":0.5},"emissiveTexture":{"index":1})");
  ASSERT_EQ(model.textures.size(), 1u);
  EXPECT_EQ(model.textures[0].rgba.at(0), 255);
  const Material& material = model.materials.at(0);
  ASSERT_TRUE(material.base_color_texture && material.metallic_roughness_texture);
  EXPECT_EQ(material.base_color_texture->wrap_u, Wrap::clamp);
  EXPECT_EQ(material.base_color_texture->wrap_v, Wrap::mirror);
  EXPECT_TRUE(material.base_color_texture->nearest);
  EXPECT_EQ(material.metallic_roughness_texture->wrap_u, Wrap::repeat);
  EXPECT_FALSE(material.metallic_roughness_texture->nearest);
  EXPECT_TRUE(material.normal_texture && material.emission_texture);
  EXPECT_FLOAT_EQ(material.normal_scale, 0.5f);
  EXPECT_EQ(first_of(model).uv.at(0), glm::vec2(0.25f, 0.5f));
  EXPECT_TRUE(first_of(read_material("")).uv.empty());
}

TEST(AssetGltfMaterials, SetsAndTransformsOfTextureCoordinatesAreApplied) {
  const auto uv = [](const std::string& info) {
    return first_of(read_material(R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0)" +
                                  info + "}}"))
        .uv.at(0);
  };
  const std::string begin = R"(,"extensions":{"KHR_texture_transform":{)";
  EXPECT_EQ(uv(R"(,"texCoord":1)"), glm::vec2(0.75f, 1.0f));
  EXPECT_EQ(uv(begin + R"("texCoord":1}})"), glm::vec2(0.75f, 1.0f));
  EXPECT_EQ(uv(begin + R"("offset":[1,2],"scale":[2,4]}})"), glm::vec2(1.5f, 4.0f));
  // A quarter turn counter-clockwise in the picture, whose v points down: (u, v) to (v, -u).
  const glm::vec2 turned = uv(begin + R"("rotation":1.5707963267948966,"offset":[0,1]}})");
  EXPECT_NEAR(turned.x, 0.5f, 1e-6f);
  EXPECT_NEAR(turned.y, 0.75f, 1e-6f);
}

TEST(AssetGltfMaterials, TexturesThatLieDifferentlyAreNoted) {
  const Model model = read_material(R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}},)"
                                    R"("emissiveTexture":{"index":0,"texCoord":1})");
  EXPECT_EQ(first_of(model).uv.at(0), glm::vec2(0.25f, 0.5f));
  EXPECT_TRUE(holds(all_notes(model), "lie differently on its surface"));
  EXPECT_TRUE(holds(all_notes(read_material(
                        R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":2}})")),
                    "for want of texture coordinates: 1 primitive."));
}

TEST(AssetGltfMaterials, MissingTexturesAreGreyAndNoted) {
  const Model model = read_material(R"("pbrMetallicRoughness":{"baseColorTexture":{"index":2}})");
  EXPECT_FALSE(model.materials.at(0).base_color_texture);
  EXPECT_FLOAT_EQ(model.materials.at(0).base_color.r, 0.4f);
  EXPECT_TRUE(holds(all_notes(model), "/images/1/uri: there is no file \"none.png\""));
  EXPECT_TRUE(holds(all_notes(read_material(R"("normalTexture":{"index":3})")),
                    "/textures/3 has no picture in PNG or JPEG, only KHR_texture_basisu"));
}

TEST(AssetGltfMaterials, FaultsAreToldWithTheirPlace) {
  EXPECT_TRUE(holds(material_message(R"("alphaMode":"CLIP")"),
                    "/materials/0/alphaMode: found \"CLIP\", expected OPAQUE, MASK or BLEND"));
  EXPECT_TRUE(holds(material_message(R"("normalTexture":{"index":9})"),
                    "/materials/0/normalTexture/index: found 9, expected one of the 4 textures"));
  EXPECT_TRUE(holds(material_message(R"("emissiveFactor":[1,2,0])"), "numbers from 0 to 1"));
  EXPECT_TRUE(holds(material_message(R"("pbrMetallicRoughness":{"metallicFactor":1.5})"),
                    "found 1.5, expected a number from 0 to 1"));
  EXPECT_TRUE(holds(material_message(R"("extensions":{"KHR_materials_ior":{"ior":0.5}})"),
                    "expected 0 or a number of at least 1"));
  EXPECT_TRUE(holds(material_message(R"("doubleSided":1)"), "found 1, expected true or false"));
  EXPECT_TRUE(holds(material_message(R"("alphaCutoff":-1)"), "a number of at least 0"));
  EXPECT_TRUE(holds(message_of(with_material("", R"(,"cameras":{})"), Format::gltf), "/cameras"));
}

}  // namespace
}  // namespace aerostat::asset
