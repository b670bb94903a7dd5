#include <cstdint>
#include <string>
#include <utility>

#include "gltf_builder.hpp"
#include "support.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

using Corners = std::vector<std::array<std::uint32_t, 3>>;

Model read_gltf_text(const std::string& text, const ReadOptions& options = {}) {
  return read_text(text, Format::gltf, options);
}

std::string gltf_message(const std::string& text, const ReadOptions& options = {}) {
  return message_of(text, Format::gltf, options);
}

TEST(AssetGltf, TextAndBinaryFilesAreTheSame) {
  GltfBuilder builder;
  builder.square();
  const std::string rest = one_mesh(R"("attributes":{"POSITION":0},"mode":5)");
  const Model text = read_gltf_text(builder.text(rest));
  EXPECT_EQ(first_of(text).triangles, (Corners{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(first_of(read_gltf_text(builder.binary(rest))).positions, first_of(text).positions);
  EXPECT_TRUE(first_of(text).normals.empty());
  EXPECT_EQ(text.materials.at(0).base_color, glm::vec4(1.0f));
  EXPECT_FLOAT_EQ(text.materials.at(0).metallic, 1.0f);
}

TEST(AssetGltf, BuffersAreFilesBesideTheModel) {
  const Folder folder;
  GltfBuilder builder;
  builder.square();
  const std::string rest = one_mesh(R"("attributes":{"POSITION":0},"mode":5)");
  folder.write("data/a buffer.bin", builder.bytes());
  folder.write("50%25.bin", builder.bytes());
  for (const char* uri :
       {"data/a%20buffer.bin", "data/a buffer.bin", "./data/A%20BUFFER.bin", "50%25.bin"}) {
    EXPECT_EQ(triangle_count(read(folder.write("m.gltf", builder.with_uri(rest, uri)))), 2u) << uri;
  }
  struct Case {
    const char *uri, *part;
  };
  for (const Case& each :
       {Case{"none.bin", "/buffers/0/uri: there is no file \"none.bin\""},
        Case{"../m.gltf/../../etc/passwd", "lies outside of the folder"},
        Case{"/etc/passwd", "is an absolute path"}, Case{"C:/data.bin", "is an absolute path"},
        Case{"http://127.0.0.1/a.bin", "expected the name of a file beside the model"},
        Case{"file:///etc/passwd", "expected the name of a file beside the model"},
        Case{"data:text/plain,abc", "expected a data URI in base64"},
        Case{"data:;base64,ab*d", "expected digits of base64"},
        Case{"data:;base64,AAAA", "expected at most the 3 bytes that are there"}}) {
    const auto file = folder.write("m.gltf", builder.with_uri(rest, each.uri));
    EXPECT_TRUE(holds(test::error_of([&] { read(file); }).what(), each.part)) << each.uri;
  }
}

TEST(AssetGltf, IndicesAreOfThreeTypesOrMissing) {
  const std::string rest = one_mesh(R"("attributes":{"POSITION":0},"indices":1)");
  const Corners expected = {{0, 1, 3}, {0, 3, 2}};
  const std::initializer_list<double> indices = {0, 1, 3, 0, 3, 2};
  GltfBuilder bytes, shorts, words;
  bytes.square().add<std::uint8_t>(5121, "SCALAR", 6, indices);
  shorts.square().add<std::uint16_t>(5123, "SCALAR", 6, indices);
  words.square().add<std::uint32_t>(5125, "SCALAR", 6, indices);
  for (const GltfBuilder* builder : {&bytes, &shorts, &words}) {
    EXPECT_EQ(first_of(read_gltf_text(builder->text(rest))).triangles, expected);
  }
  GltfBuilder missing;
  missing.floats("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  EXPECT_EQ(
      first_of(read_gltf_text(missing.text(one_mesh(R"("attributes":{"POSITION":0})")))).triangles,
      (Corners{{0, 1, 2}}));
  GltfBuilder wrong;
  wrong.square().add<std::uint8_t>(5121, "SCALAR", 3, {0, 1, 4});
  EXPECT_TRUE(
      holds(gltf_message(wrong.text(rest)),
            "/meshes/0/primitives/0/indices: found the index 4 at place 2, expected indices "
            "of the 4 vertices, from 0"));
}

TEST(AssetGltf, StripsAndFansBecomeTriangles) {
  GltfBuilder builder;
  builder.square().add<std::uint8_t>(5121, "SCALAR", 7, {0, 1, 2, 2, 1, 1, 3});
  const auto triangles = [&](const std::string& mode) {
    return first_of(read_gltf_text(builder.text(one_mesh(R"("attributes":{"POSITION":0})" + mode))))
        .triangles;
  };
  EXPECT_EQ(triangles(R"(,"mode":5)"), (Corners{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(triangles(R"(,"mode":6)"), (Corners{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(triangles(R"(,"mode":5,"indices":1)").size(), 1u);  // the others are folded
  const Model lines = read_gltf_text(builder.text(
      R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
      R"({"attributes":{"POSITION":0},"mode":1},{"attributes":{"POSITION":0},"mode":5}]}])"));
  EXPECT_EQ(triangle_count(lines), 2u);
  EXPECT_TRUE(holds(all_notes(lines), "Left out: 1 primitive of points or lines."));
}

TEST(AssetGltf, NormalizedIntegersAndColoursAreFractions) {
  GltfBuilder builder;
  builder.square()
      .add<std::int8_t>(5120, "VEC3", 4, {0, 0, 127, 0, 0, -128, 0, 127, 0, 0, 0, 0},
                        R"(,"normalized":true)")
      .add<std::uint8_t>(5121, "VEC4", 4, {255, 51, 0, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                         R"(,"normalized":true)");
  const std::string rest =
      one_mesh(R"("attributes":{"POSITION":0,"COLOR_0":2,"NORMAL":1},"mode":5)");
  EXPECT_TRUE(holds(gltf_message(builder.text(rest)), "/attributes/NORMAL: found VEC3 of 5120"));
  const std::string quantized = R"("extensionsUsed":["KHR_mesh_quantization"],)" + rest;
  const Model model = read_gltf_text(builder.text(quantized));
  EXPECT_EQ(first_of(model).colors.at(0), glm::vec4(1.0f, 0.2f, 0.0f, 1.0f));
  EXPECT_EQ(first_of(model).normals.at(1), glm::vec3(0.0f, 0.0f, -1.0f));
  EXPECT_EQ(first_of(model).normals.at(3), glm::vec3(0.0f, 0.0f, 1.0f));  // of its triangle
}

TEST(AssetGltf, QuantizedPositionsAreIntegers) {
  GltfBuilder builder;
  builder.add<std::int16_t>(5122, "VEC3", 3, {0, 0, 0, 100, 0, 0, 0, -50, 0});
  const std::string rest =
      one_mesh(R"("attributes":{"POSITION":0})", R"(,"scale":[0.01,0.01,0.01])");
  EXPECT_TRUE(holds(gltf_message(builder.text(rest)), "/attributes/POSITION: found VEC3 of 5122"));
  const Model model =
      read_gltf_text(builder.text(R"("extensionsRequired":["KHR_mesh_quantization"],)"
                                  R"("extensionsUsed":["KHR_mesh_quantization"],)" +
                                  rest));
  EXPECT_NEAR(bounds(model).least.y, -0.5, 1e-12);
}

TEST(AssetGltf, TheLeastNormalizedIntegerIsMinusOne) {
  GltfBuilder builder;
  builder.add<std::int8_t>(5120, "VEC3", 3, {-128, 0, 0, 127, 0, 0, 0, -127, 0},
                           R"(,"normalized":true)");
  const Model model = read_gltf_text(builder.text(R"("extensionsUsed":["KHR_mesh_quantization"],)" +
                                                  one_mesh(R"("attributes":{"POSITION":0})")));
  EXPECT_EQ(first_of(model).positions, (std::vector<glm::vec3>{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}}));
}

TEST(AssetGltf, SparseAccessorsReplaceSomeElements) {
  GltfBuilder builder;
  builder.view(std::string("\x01\0\x02\0", 4));
  const float values[] = {5, 0, 0, 0, 6, 0};
  builder.view(std::string(reinterpret_cast<const char*>(values), sizeof(values)));
  const std::string begin = R"({"componentType":5126,"type":"VEC3","count":3,"sparse":{"count":2,)";
  const std::string end = R"("indices":{"bufferView":0,"componentType":5123},)"
                          R"("values":{"bufferView":1}}})";
  const std::string rest = one_mesh(R"("attributes":{"POSITION":0})");
  GltfBuilder good = builder;
  good.accessor(begin + end);
  EXPECT_EQ(first_of(read_gltf_text(good.text(rest))).positions,
            (std::vector<glm::vec3>{{0, 0, 0}, {5, 0, 0}, {0, 6, 0}}));
  GltfBuilder short_one = builder;
  short_one.accessor(R"({"componentType":5126,"type":"VEC3","count":2,"sparse":{"count":2,)" + end);
  EXPECT_TRUE(holds(gltf_message(short_one.text(rest)),
                    "/accessors/0/sparse/indices: found 2, expected indices below 2 that rise"));
  GltfBuilder long_one = builder;
  long_one.accessor(R"({"componentType":5126,"type":"VEC3","count":3,"sparse":{"count":3,)" + end);
  EXPECT_TRUE(
      holds(gltf_message(long_one.text(rest)), "/accessors/0/sparse/indices: found 3 elements"));
}

TEST(AssetGltf, StridesOfViewsSkipOtherAttributes) {
  GltfBuilder builder;
  const float numbers[] = {0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9};
  builder.view(std::string(reinterpret_cast<const char*>(numbers), sizeof(numbers)),
               R"(,"byteStride":16)");
  builder.accessor(R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":3})");
  const std::string rest = one_mesh(R"("attributes":{"POSITION":0})");
  EXPECT_EQ(first_of(read_gltf_text(builder.text(rest))).positions,
            (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(AssetGltf, PrimitivesTakeOnlyTheVerticesThatTheyUse) {
  GltfBuilder builder;
  builder.floats("VEC3", 6, {9, 9, 9, 0, 0, 0, 1, 0, 0, 9, 9, 9, 0, 1, 0, 0, 0, 1})
      .add<std::uint8_t>(5121, "SCALAR", 3, {4, 1, 2})
      .add<std::uint8_t>(5121, "SCALAR", 3, {1, 2, 5});
  const std::string begin = R"({"attributes":{"POSITION":0},"indices":)";
  const std::string text =
      builder.text(R"("meshes":[{"primitives":[)" + begin + "1}," + begin + "2}]}]");
  ReadOptions options;
  options.limits.vertices = 6;
  const Model model = read_gltf_text(text, options);
  EXPECT_EQ(first_of(model).positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(first_of(model).triangles, (Corners{{2, 0, 1}}));
  options.limits.vertices = 5;
  EXPECT_TRUE(holds(gltf_message(text, options),
                    "found 3 vertices and then 3 more, and at most 5 are read of a model"));

  GltfBuilder sparse;
  const float values[] = {5, 0, 0, 0, 6, 0};
  sparse.view(std::string("\x01\0\x07\0", 4))
      .view(std::string(reinterpret_cast<const char*>(values), sizeof(values)))
      .accessor(R"({"componentType":5126,"type":"VEC3","count":1000000,"sparse":{"count":2,)"
                R"("indices":{"bufferView":0,"componentType":5123},"values":{"bufferView":1}}})")
      .view(std::string("\0\1\7", 3))
      .accessor(R"({"bufferView":2,"componentType":5121,"type":"SCALAR","count":3})");
  EXPECT_EQ(
      first_of(read_gltf_text(sparse.text(one_mesh(R"("attributes":{"POSITION":0},"indices":1)"))))
          .positions,
      (std::vector<glm::vec3>{{0, 0, 0}, {5, 0, 0}, {0, 6, 0}}));
}

TEST(AssetGltf, AccessorsStayInTheirViews) {
  struct Case {
    const char *accessor, *part;
  };
  for (const Case& each :
       {Case{R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":5})",
             "/accessors/0: found 5 elements from byte 0, expected what lies in the 48 bytes"},
        Case{R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":4,"byteOffset":4})",
             "found 4 elements from byte 4"},
        Case{R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":9007199254740991})",
             "found 9007199254740991 elements"},
        Case{R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":1,"byteOffset":2})",
             "a multiple of their 4 bytes"},
        Case{R"({"componentType":5126,"type":"VEC3","count":9007199254740991})",
             "found 3002399751580330 triangles, and at most 20000000 are read"},
        Case{R"({"bufferView":0,"componentType":5124,"type":"VEC3","count":1})",
             "/accessors/0/componentType: found 5124, expected 5120"},
        Case{R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":1,"normalized":true})",
             "/accessors/0/normalized"},
        Case{R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":-1})",
             "/accessors/0/count: found -1, expected an integer that is not negative"},
        Case{R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":1.5})", "found 1.5"},
        Case{R"({"bufferView":1,"componentType":5126,"type":"VEC3","count":1})",
             "/accessors/0/bufferView: found 1, expected one of the 1 bufferViews"},
        Case{R"({"byteOffset":4,"componentType":5126,"type":"VEC3","count":1})",
             "a bufferView, because there is a byteOffset"}}) {
    GltfBuilder builder;
    builder.view(std::string(48, '\0')).accessor(each.accessor);
    EXPECT_TRUE(
        holds(gltf_message(builder.text(one_mesh(R"("attributes":{"POSITION":0})"))), each.part));
  }
}

TEST(AssetGltf, AttributesHaveTheirFormsAndOneElementAVertex) {
  GltfBuilder builder;
  builder.square()
      .floats("VEC3", 3, {0, 0, 1, 0, 0, 1, 0, 0, 1})
      .floats("VEC4", 4, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  const auto message = [&](const std::string& attributes) {
    return gltf_message(builder.text(one_mesh(R"("attributes":{)" + attributes + "}")));
  };
  EXPECT_TRUE(holds(message(R"("POSITION":0,"NORMAL":1)"),
                    "found 4 elements, expected 3, as the other attributes have"));
  EXPECT_TRUE(holds(message(R"("POSITION":2)"), "/attributes/POSITION: found VEC4 of 5126"));
  EXPECT_TRUE(holds(message(R"("POSITION":0,"normal":0)"), "expected what normal may be"));
  EXPECT_TRUE(holds(message(R"("POSITION":3)"), "expected one of the 3 accessors"));
  EXPECT_TRUE(holds(message(""), "expected the attributes of vertices"));
}

TEST(AssetGltf, PiecesOfBinaryFilesAreChecked) {
  GltfBuilder builder;
  builder.square();
  const std::string good = builder.binary(one_mesh(R"("attributes":{"POSITION":0},"mode":5)"));
  EXPECT_EQ(triangle_count(read_gltf_text(good + "more")), 2u);
  EXPECT_TRUE(holds(gltf_message(good.substr(0, good.size() - 4)), "byte 8: found a length of"));
  EXPECT_TRUE(holds(gltf_message("glTF" + GltfBuilder::word(1) + good.substr(8)),
                    "byte 4: found version 1, expected 2"));
  EXPECT_TRUE(holds(gltf_message("glTF"), "the file ends inside of its header"));
  EXPECT_TRUE(holds(gltf_message("glTF" + GltfBuilder::word(2) + GltfBuilder::word(12)),
                    "byte 12: found the end of the file, expected a chunk"));
  EXPECT_TRUE(holds(gltf_message("glTF" + GltfBuilder::word(2) + GltfBuilder::word(24) +
                                 GltfBuilder::word(5) + GltfBuilder::word(0x4e4f534a) + "{}  "),
                    "found a chunk of 5 bytes, but only 4 are left"));
  EXPECT_TRUE(holds(gltf_message("glTF" + GltfBuilder::word(2) + GltfBuilder::word(24) +
                                 GltfBuilder::chunk(1, "{}  ")),
                    "byte 16: found another chunk"));
}

TEST(AssetGltf, OtherVersionsAndUnknownExtensionsAreRefusedByName) {
  const auto message = [](const std::string& text) { return gltf_message(text); };
  EXPECT_TRUE(holds(message(R"({"asset":{"version":"1.0"}})"),
                    "/asset/version: found \"1.0\", expected version 2.0 of glTF"));
  EXPECT_TRUE(holds(message("{}"), "/asset/version: found nothing"));
  EXPECT_TRUE(
      holds(message(R"({"asset":{"version":"2.0","minVersion":"2.1"}})"), "/asset/minVersion"));
  const auto required = [&](const std::string& name) {
    return message(R"({"asset":{"version":"2.0"},"extensionsRequired":[")" + name + R"("]})");
  };
  EXPECT_TRUE(
      holds(required("KHR_draco_mesh_compression"),
            "/extensionsRequired/0: found \"KHR_draco_mesh_compression\" (meshes compressed "
            "by Draco), expected only these extensions"));
  EXPECT_TRUE(holds(required("EXT_meshopt_compression"), "compressed by meshoptimizer"));
  EXPECT_TRUE(holds(required("KHR_texture_basisu"), "textures in KTX2"));
  EXPECT_TRUE(holds(required("ACME_thing"), "ACME_thing"));
  EXPECT_TRUE(holds(required("KHR_texture_transform"), "no triangle that can be drawn"));
  GltfBuilder builder;
  builder.square();
  EXPECT_TRUE(holds(
      all_notes(read_gltf_text(builder.text(R"("extensionsUsed":["ACME_thing"],)" +
                                            one_mesh(R"("attributes":{"POSITION":0},"mode":5)")))),
      "The extension ACME_thing is left out."));
}

TEST(AssetGltf, JsonIsStrictAndHasLimits) {
  EXPECT_TRUE(holds(gltf_message("{"), "JSON: line 1, column 1"));
  EXPECT_TRUE(holds(gltf_message("{} // a comment"), "line 1, column 4"));
  EXPECT_TRUE(holds(gltf_message(R"({"asset":{},"asset":{}})"), "this key twice"));
  EXPECT_TRUE(holds(gltf_message(std::string(70, '[')), "at most 64 levels"));
  EXPECT_TRUE(holds(gltf_message(R"({"asset":{"version":"2.0"},"nodes":{}})"),
                    "/nodes: found an object, expected an array"));
  EXPECT_TRUE(holds(gltf_message("[]"), "expected an object"));
  // The parser repeats what it has read, and that may look like its own words.
  std::string odd = R"({"a" "'; expected ")";
  for (int i = 0; i < 200; ++i) odd += "\xC3\xA4";
  EXPECT_TRUE(track::is_utf8(gltf_message(odd + "\"}")));
  EXPECT_TRUE(track::is_utf8(gltf_message("{\"a\" \"'; expected \xff\"}")));
}

// Each file has nothing to draw and one fault in what is not read.
TEST(AssetGltf, NamesTheFaultOfAFileWithoutTriangles) {
  const auto message = [](const std::string& rest) {
    return gltf_message(R"({"asset":{"version":"2.0"},)" + rest + "}");
  };
  const std::string times =
      R"("accessors":[{"componentType":5126,"type":"SCALAR","count":1,"min":[0],"max":[1]},
         {"componentType":5126,"type":"VEC3","count":1}],"nodes":[{},{"matrix":
         [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}],)";
  const auto animation = [&](const std::string& channels, const std::string& sampler) {
    return message(times + R"("animations":[{"channels":[)" + channels + R"(],"samplers":[)" +
                   sampler + "]}]");
  };
  const std::string good = R"({"sampler":0,"target":{"node":0,"path":"scale"}})";
  const std::string sampler = R"({"input":0,"output":1})";
  const auto channel = [&](const std::string& index, const std::string& target) {
    return animation(R"({"sampler":)" + index + R"(,"target":{)" + target + "}}", sampler);
  };
  const std::pair<std::string, std::string> kCases[] = {
      {message(R"("textures":[])"), "/textures: found [], expected at least one element"},
      {message(R"("nodes":[{"children":[]}])"), "/nodes/0/children"},
      {message(R"("scenes":[{"nodes":[]}])"), "/scenes/0/nodes"},
      {message(R"("extensionsUsed":["A","A"])"), "/extensionsUsed/1"},
      {message(R"("nodes":[{"camera":2}])"), "/nodes/0/camera"},
      {message(R"("nodes":[{"weights":[1]}])"), "/nodes/0/mesh"},
      {message(R"("nodes":[{"rotation":[0,0,0,2]}])"), "/nodes/0/rotation"},
      {message(R"("cameras":[{}])"), "/cameras/0/type"},
      {message(R"("cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":2,"zfar":1}}])"),
       "/cameras/0/perspective/zfar"},
      {message(R"("cameras":[{"type":"orthographic",
                  "orthographic":{"xmag":0,"ymag":1,"znear":0,"zfar":1}}])"),
       "/cameras/0/orthographic/xmag"},
      {animation("", sampler), "/animations/0/channels"},
      {animation(good, ""), "/animations/0/samplers"},
      {animation(good, R"({"input":1,"output":1})"), "/animations/0/samplers/0/input"},
      {animation(good, R"({"input":0,"output":7})"), "/animations/0/samplers/0/output"},
      {animation(good + "," + good, sampler), "/animations/0/channels/1/target"},
      {channel("1", R"("path":"scale")"), "/animations/0/channels/0/sampler"},
      {channel("0", R"("node":9,"path":"scale")"), "/animations/0/channels/0/target/node"},
      {channel("0", R"("node":1,"path":"scale")"), "/animations/0/channels/0/target/node"},
      {channel("0", R"("node":0)"), "/animations/0/channels/0/target/path"},
      {animation(good, sampler), "no triangle that can be drawn"}};
  for (const auto& [found, expected] : kCases) EXPECT_TRUE(holds(found, expected));
}

TEST(AssetGltf, NamesTheFaultOfMeshesThatStandNowhere) {
  const auto message = [](const std::string& mesh) {
    GltfBuilder builder;
    builder.square().accessor(
        R"({"componentType":5126,"type":"VEC3","count":4,"min":[0,0,0],"max":[1,1,0]})");
    return gltf_message(builder.text(R"("nodes":[{}],"meshes":[{)" + mesh + "}]"));
  };
  EXPECT_TRUE(holds(message(R"("primitives":[{"attributes":{"POSITION":0}}])"),
                    "/accessors/0/min: found nothing, expected 3 numbers"));
  const std::string bounded = R"("attributes":{"POSITION":1})";
  EXPECT_TRUE(
      holds(message(R"("primitives":[{)" + bounded + R"(}],"weights":[1])"), "/meshes/0/weights"));
  EXPECT_TRUE(holds(message(R"("primitives":[{)" + bounded + "},{" + bounded +
                            R"(,"targets":[{"POSITION":0}]}])"),
                    "/meshes/0/primitives/1/targets"));
}

}  // namespace
}  // namespace aerostat::asset
