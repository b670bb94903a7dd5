#include <cstdint>
#include <string>
#include <vector>

#include "support.hpp"

namespace aerostat::asset {
namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.5\n";
/// A PNG of one pixel, a grey of 100.
const std::string kGreyPng(
    "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\001\000\000\000"
    "\001\010\000\000\000\000\072\176\233\125\000\000\000\012\111\104\101\124\170\234\143\110\001"
    "\000\000\146\000\145\172\240\306\222\000\000\000\000\111\105\116\104\256\102\140\202",
    67);
constexpr const char* kFace = "f 1/1 2/1 3/1\n";

/// Returns the model of a triangle whose material is "m" of the given text.
Model read_with(const std::string& materials, const Folder& folder = {}) {
  folder.write("m.mtl", "newmtl m\n" + materials);
  return read(
      folder.write("model.obj", std::string(kTriangle) + "mtllib m.mtl\nusemtl m\n" + kFace));
}

Material material_with(const std::string& materials) {
  return read_with(materials).materials.at(0);
}

TEST(AssetMtl, NumbersOfMaterialsAreUnderstood) {
  const Material shiny = material_with("Kd 1 0.5 0\nKs 1 1 1\nNs 30\nNi 1.3\nKe 0 0 1\nillum 2\n");
  EXPECT_NEAR(shiny.base_color.g, 0.2140f, 1e-4f);
  EXPECT_FLOAT_EQ(shiny.roughness, 0.5f);
  EXPECT_FLOAT_EQ(shiny.ior, 1.3f);
  EXPECT_EQ(shiny.emission, glm::vec3(0.0f, 0.0f, 1.0f));
  EXPECT_EQ(shiny.alpha, AlphaMode::opaque);
  EXPECT_TRUE(shiny.double_sided);
  EXPECT_FLOAT_EQ(material_with("Ks 0 0 0\nNs 30\n").roughness, 1.0f);
  EXPECT_FLOAT_EQ(material_with("Pr 0.25\nPm 1\n").roughness, 0.25f);
  EXPECT_FLOAT_EQ(material_with("Pr 0.25\nPm 1\n").metallic, 1.0f);
  EXPECT_FLOAT_EQ(material_with("Kd 0.5\n").base_color.b,
                  material_with("Kd 0.5 0.5 0.5\n").base_color.b);
}

TEST(AssetMtl, OpacityIsDOrOneMinusTr) {
  EXPECT_FLOAT_EQ(material_with("d 0.25\n").base_color.a, 0.25f);
  EXPECT_EQ(material_with("d 0.25\n").alpha, AlphaMode::blend);
  EXPECT_FLOAT_EQ(material_with("Tr 0.25\n").base_color.a, 0.75f);
  EXPECT_FLOAT_EQ(material_with("Tr 1\nd 1\n").base_color.a, 1.0f);
  EXPECT_FLOAT_EQ(material_with("d -halo 0.5\n").base_color.a, 0.5f);
  const Model hidden = read_with("Tr 1\n");
  EXPECT_FLOAT_EQ(hidden.materials.at(0).base_color.a, 1.0f);
  EXPECT_TRUE(holds(all_notes(hidden), "would be invisible"));
}

TEST(AssetMtl, TexturesAreReadWithTheirOptions) {
  const Folder folder;
  folder.write("a picture.png", png_2x1());
  const Model model = read_with(
      "map_Kd -clamp on -s 2 3 1 -o 0.5 -mm 0 1 a picture.png\nmap_Ke a picture.png\nKe 1 1 1\n"
      "norm -bm 0.5 a picture.png\nmap_Ns other.png\n",
      folder);
  ASSERT_EQ(model.textures.size(), 1u);  // each file once
  EXPECT_EQ(model.textures[0].width, 2u);
  EXPECT_EQ(model.textures[0].rgba.at(4), 0);
  EXPECT_EQ(model.textures[0].rgba.at(5), 255);
  const Material& material = model.materials.at(0);
  ASSERT_TRUE(material.base_color_texture && material.emission_texture && material.normal_texture);
  EXPECT_EQ(material.base_color_texture->wrap_u, Wrap::clamp);
  EXPECT_EQ(material.emission_texture->wrap_u, Wrap::repeat);
  EXPECT_FLOAT_EQ(material.normal_scale, 0.5f);
  EXPECT_EQ(first_of(model).uv.at(0), glm::vec2(0.25f * 2 + 0.5f, 1.0f - 0.5f * 3));
  EXPECT_EQ(glm::vec3(material.base_color), glm::vec3(1.0f));
  EXPECT_EQ(material.alpha, AlphaMode::mask);  // a pixel is see-through
  EXPECT_TRUE(holds(all_notes(model), "Textures of the kind \"map_ns\" are left out."));
}

TEST(AssetMtl, NumbersThatAreNotFiniteBecomeZero) {
  const Model model = read_with("Kd nan 1 1\nNs inf\nKs 1 1 1\nmap_Kd -bm nan none.png\n");
  EXPECT_FLOAT_EQ(model.materials.at(0).base_color.r, 0.0f);
  EXPECT_FLOAT_EQ(model.materials.at(0).roughness, 1.0f);
  EXPECT_TRUE(holds(all_notes(model), "Numbers of materials that are not finite became 0."));
}

TEST(AssetMtl, OpacityMayHaveATextureOfItsOwn) {
  const Folder folder;
  folder.write("holes.png", png_2x1());
  folder.write("grey.png", kGreyPng);
  const Model holes = read_with("map_d holes.png\n", folder);
  ASSERT_EQ(holes.textures.size(), 1u);
  EXPECT_EQ(holes.textures[0].rgba, (std::vector<std::uint8_t>{255, 255, 255, 255,  //
                                                               255, 255, 255, 0}));
  EXPECT_EQ(holes.materials.at(0).alpha, AlphaMode::mask);
  const Model colored = read_with("map_Kd holes.png\nmap_d grey.png\n", folder);
  ASSERT_EQ(colored.textures.size(), 1u);
  EXPECT_EQ(colored.textures[0].rgba, (std::vector<std::uint8_t>{255, 0, 0, 100,  //
                                                                 0, 255, 0, 100}));
  EXPECT_TRUE(holds(all_notes(read_with("map_d none.png\n")), "there is no file \"none.png\""));
}

TEST(AssetMtl, ABlackColourDoesNotHideATexture) {
  const Folder folder;
  folder.write("t.png", png_2x1());
  const Model model = read_with("Kd 0 0 0\nmap_Kd t.png\n", folder);
  EXPECT_EQ(glm::vec3(model.materials.at(0).base_color), glm::vec3(1.0f));
  EXPECT_TRUE(holds(all_notes(model), "black colour"));
}

TEST(AssetMtl, FilesAreFoundByTheNamesThatProgramsWrite) {
  const Folder folder;
  folder.write("maps/Wood.PNG", png_2x1());
  folder.write("My Materials.MTL", "newmtl m\nmap_Kd maps\\wood.png\n");
  for (const char* name : {"my materials.mtl", "./My Materials.MTL",
                           "C:\\Users\\me\\my materials.mtl", "/home/me/My Materials.MTL"}) {
    const Model model = read(folder.write(
        "model.obj", std::string(kTriangle) + "mtllib " + name + "\nusemtl m\n" + kFace));
    EXPECT_EQ(model.textures.size(), 1u) << name << "\n" << all_notes(model);
  }
  const Model two = read(folder.write(
      "two.obj", std::string(kTriangle) + "mtllib none.mtl other.mtl\nusemtl m\n" + kFace));
  EXPECT_TRUE(holds(all_notes(two), "there is no file \"none.mtl\""));
  EXPECT_TRUE(holds(all_notes(two), "there is no file \"other.mtl\""));
  EXPECT_TRUE(holds(all_notes(two), "The material \"m\" is missing, and grey takes its place."));
  EXPECT_FLOAT_EQ(two.materials.at(0).base_color.r, 0.5f);
}

TEST(AssetMtl, NothingOutsideOfTheFolderIsRead) {
  const Folder folder;
  folder.write("secret.mtl", "newmtl m\nKd 1 0 0\n");
  folder.write("secret.png", png_2x1());
  folder.write("inside/m.mtl", "newmtl m\nmap_Kd ../secret.png\n");
  const std::string obj = std::string(kTriangle) + "usemtl m\n" + kFace;
  const auto file = folder.write("inside/model.obj", "mtllib ../secret.mtl\n" + obj);
  EXPECT_TRUE(holds(all_notes(read(file)), "\"../secret.mtl\" lies outside of the folder"));
  const auto textured = folder.write("inside/textured.obj", "mtllib m.mtl\n" + obj);
  EXPECT_TRUE(read(textured).textures.empty());
  EXPECT_TRUE(holds(all_notes(read(textured)), "\"../secret.png\" lies outside of the folder"));
  ReadOptions options;
  options.folder = folder.path();
  EXPECT_FLOAT_EQ(read(file, options).materials.at(0).base_color.g, 0.0f);
  EXPECT_EQ(read(textured, options).textures.size(), 1u);
  options.folder.reset();
  options.allow_external = true;
  EXPECT_EQ(read(textured, options).textures.size(), 1u);

  std::filesystem::create_symlink(folder.path() / "secret.mtl", folder.path() / "inside/link.mtl");
  const auto linked = folder.write("inside/linked.obj", "mtllib link.mtl\n" + obj);
  EXPECT_TRUE(holds(all_notes(read(linked)), "lies outside of the folder"));
}

TEST(AssetMtl, AMissingTextureIsGreyAndNoted) {
  const Model model = read_with("Kd 1 1 1\nmap_Kd none.png\n");
  EXPECT_FALSE(model.materials.at(0).base_color_texture);
  EXPECT_FLOAT_EQ(model.materials.at(0).base_color.r, 0.4f);
  EXPECT_TRUE(holds(all_notes(model), "A texture is left out: there is no file \"none.png\"."));
}

TEST(AssetMtl, OtherPicturesAreToldByName) {
  const Folder folder;
  folder.write("t.webp", std::string("RIFF\0\0\0\0WEBPVP8 ", 16));
  EXPECT_TRUE(holds(all_notes(read_with("map_Kd t.webp\n", folder)),
                    "t.webp: found a WebP, expected a PNG or JPEG"));
  std::string odd = png_2x1();
  odd.replace(odd.find("IDAT"), 4, "I\xff\x01T");
  folder.write("t.png", odd);
  EXPECT_TRUE(holds(all_notes(read_with("map_Kd t.png\n", folder)), "I[FF][01]T"));
  folder.write("t.png", png_2x1().substr(0, 50));
  EXPECT_TRUE(holds(all_notes(read_with("map_Kd t.png\n", folder)), "cannot be decoded"));
  folder.write("t.png", png_2x1());
  folder.write("m.mtl", "newmtl m\nmap_Kd t.png\n");
  ReadOptions options;
  options.limits.texture_side = 1;
  const auto file =
      folder.write("model.obj", std::string(kTriangle) + "mtllib m.mtl\nusemtl m\n" + kFace);
  EXPECT_TRUE(holds(all_notes(read(file, options)), "2 x 1 pixels, and at most 1 a side"));
}

TEST(AssetMtl, LimitsAreTold) {
  const Folder folder;
  folder.write("m.mtl", "newmtl m\nnewmtl n\n");
  const auto file =
      folder.write("model.obj", std::string(kTriangle) + "mtllib m.mtl\nusemtl m\n" + kFace);
  ReadOptions options;
  options.limits.materials = 1;
  EXPECT_TRUE(holds(test::error_of([&] { read(file, options); }).what(),
                    "m.mtl: line 2: found one more material, and at most 1 are read"));
  options.limits.file_bytes = 20;
  EXPECT_TRUE(
      holds(test::error_of([&] { read(file, options); }).what(), "bytes, and at most 20 are read"));
}

TEST(AssetMtl, FaultsNameTheFileAndTheLine) {
  const Folder folder;
  folder.write("m.mtl", "newmtl m\nKd 0,5 0 0\n");
  const auto file =
      folder.write("model.obj", std::string(kTriangle) + "mtllib m.mtl\nusemtl m\n" + kFace);
  EXPECT_TRUE(
      holds(test::error_of([&] { read(file); }).what(),
            "model.obj: m.mtl: line 2: found \"0,5\", expected a number whose decimal mark"));
}

}  // namespace
}  // namespace aerostat::asset
