#include <cstdint>
#include <string>

#include "gltf_builder.hpp"
#include "support.hpp"

namespace aerostat::asset {
namespace {

constexpr const char* kMesh =
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}])";

std::string with_nodes(const std::string& nodes, const std::string& scenes) {
  GltfBuilder builder;
  builder.square();
  return builder.text(R"("nodes":[)" + nodes + R"(],"scenes":)" + scenes + "," + kMesh);
}

Model read_nodes(const std::string& nodes, const std::string& scenes = R"([{"nodes":[0]}])") {
  return read_text(with_nodes(nodes, scenes), Format::gltf);
}

std::string nodes_message(const std::string& nodes,
                          const std::string& scenes = R"([{"nodes":[0]}])",
                          const ReadOptions& options = {}) {
  return message_of(with_nodes(nodes, scenes), Format::gltf, options);
}

glm::dvec3 placed(const Model& model, const glm::dvec3& point) {
  return glm::dvec3(model.placements.at(0).transform * glm::dvec4(point, 1.0));
}

TEST(AssetGltfNodes, TransformsAreComposedFromTheRoot) {
  // A quarter turn about y takes x to -z.
  const Model model = read_nodes(
      R"({"children":[1],"translation":[10,0,0],"rotation":[0,0.7071067811865476,0,0.7071067811865476],)"
      R"("scale":[2,2,2]},{"mesh":0,"matrix":[1,0,0,0, 0,3,0,0, 0,0,1,0, 0,0,5,1]})");
  const glm::dvec3 corner = placed(model, {1.0, 1.0, 0.0});
  EXPECT_NEAR(corner.x, 20.0, 1e-12);
  EXPECT_NEAR(corner.y, 6.0, 1e-12);
  EXPECT_NEAR(corner.z, -2.0, 1e-12);
}

TEST(AssetGltfNodes, NegativeScalesStayInTheTransform) {
  const Model model = read_nodes(R"({"mesh":0,"scale":[-1,1,1]})");
  EXPECT_LT(glm::determinant(glm::dmat3(model.placements.at(0).transform)), 0.0);
  EXPECT_EQ(bounds(model).least.x, -1.0);
}

TEST(AssetGltfNodes, TheDefaultSceneIsRead) {
  const std::string nodes = R"({"mesh":0},{"mesh":0,"translation":[5,0,0]},{"mesh":0})";
  EXPECT_EQ(read_nodes(nodes, R"([{"nodes":[0]},{"nodes":[1,2]}])").placements.size(), 1u);
  const Model second = read_nodes(nodes, R"([{"nodes":[0]},{"nodes":[1]}],"scene":1)");
  EXPECT_EQ(second.placements.size(), 1u);
  EXPECT_EQ(second.placements[0].transform[3].x, 5.0);
  EXPECT_EQ(second.meshes.size(), 1u);
  EXPECT_EQ(read_nodes(nodes, "[]").placements.size(), 3u);
  GltfBuilder builder;
  builder.square();
  EXPECT_EQ(read_text(builder.text(kMesh), Format::gltf).placements.size(), 1u);
}

TEST(AssetGltfNodes, ModelsFarAwayAreMovedNear) {
  const Model model = read_nodes(R"({"mesh":0,"translation":[487654.25,0,-5212345]})");
  EXPECT_EQ(model.origin, glm::dvec3(487655.0, 0.0, -5212345.0));
  EXPECT_EQ(bounds(model).least, glm::dvec3(-0.75, 0.0, 0.0));
}

TEST(AssetGltfNodes, FaultsOfTreesAreTold) {
  EXPECT_TRUE(holds(nodes_message(R"({"children":[1]},{"children":[0]})"), "their own parents"));
  EXPECT_TRUE(holds(nodes_message(R"({"children":[0]})"), "their own parents"));
  EXPECT_TRUE(holds(nodes_message(R"({"children":[2]},{"children":[2]},{})"),
                    "/nodes/1/children/0: found 2, expected a node that has no other parent"));
  EXPECT_TRUE(holds(nodes_message(R"({"children":[7]})"), "expected one of the 1 nodes"));
  EXPECT_TRUE(holds(nodes_message(R"({"children":[1]},{})", R"([{"nodes":[1]}])"),
                    "/scenes/0/nodes/0: found 1, expected a node that has no parent"));
  EXPECT_TRUE(holds(nodes_message("{}", R"([{"nodes":[0]}],"scene":1)"), "/scene: found 1"));
  EXPECT_TRUE(holds(nodes_message(R"({"mesh":1})"), "/nodes/0/mesh: found 1"));
  EXPECT_TRUE(holds(nodes_message(R"({"rotation":[0,0,0,0]})"), "a quaternion"));
  EXPECT_TRUE(holds(nodes_message(R"({"rotation":[0,0,1]})"), "expected 4 numbers"));
  EXPECT_TRUE(
      holds(nodes_message(R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"scale":[1,1,1]})"),
            "either a matrix or translation"));
  EXPECT_TRUE(holds(nodes_message(R"({"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]})"), "last row"));
  EXPECT_TRUE(
      holds(nodes_message(R"({"mesh":0,"scale":[0,1,1]})"), "no triangle that can be drawn"));
}

TEST(AssetGltfNodes, LimitsOfTreesAreTold) {
  ReadOptions options;
  options.limits.node_depth = 1;
  EXPECT_TRUE(holds(nodes_message(R"({"children":[1]},{})", R"([{"nodes":[0]}])", options),
                    "/nodes/1: found deeper nesting of nodes, expected at most 1 levels"));
  options = {};
  options.limits.nodes = 1;
  EXPECT_TRUE(holds(nodes_message("{},{}", R"([{"nodes":[0]}])", options),
                    "found 2 nodes, and at most 1 are read"));
  options = {};
  options.limits.placements = 1;
  EXPECT_TRUE(holds(nodes_message(R"({"mesh":0},{"mesh":0})", R"([{"nodes":[0,1]}])", options),
                    "found 1 placements of meshes and then 1 more, and at most 1 are read"));
}

TEST(AssetGltfNodes, InstancesAreManyPlacements) {
  GltfBuilder builder;
  builder.square()
      .floats("VEC3", 3, {0, 0, 0, 10, 0, 0, 20, 0, 0})
      .floats("VEC3", 3, {1, 1, 1, 2, 2, 2, 0, 0, 0})
      .floats("VEC3", 2, {1, 1, 1, 2, 2, 2});
  const auto text = [&](const std::string& attributes) {
    return builder.text(
        R"("extensionsUsed":["EXT_mesh_gpu_instancing"],)" +
        one_mesh(
            R"("attributes":{"POSITION":0},"mode":5)",
            R"(,"translation":[0,5,0],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{)" +
                attributes + "}}}"));
  };
  const Model model = read_text(text(R"("TRANSLATION":1,"SCALE":2)"), Format::gltf);
  ASSERT_EQ(model.placements.size(), 2u);
  EXPECT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(bounds(model).most, glm::dvec3(12.0, 7.0, 0.0));
  EXPECT_TRUE(holds(all_notes(model), "Left out because their size is 0: 1 placed mesh."));
  EXPECT_TRUE(holds(message_of(text(R"("TRANSLATION":1,"SCALE":3)"), Format::gltf),
                    "/SCALE: found 3, expected as many as the others"));
  EXPECT_TRUE(holds(message_of(text(R"("ROTATION":1)"), Format::gltf), "an accessor of VEC4"));
}

/// Returns a file whose square hangs on two joints: the left corners on node 1, the right ones on
/// node 2, which is moved up by 3.
std::string with_skin(const std::string& skin, const std::string& attributes) {
  GltfBuilder builder;
  builder.square()
      .add<std::uint8_t>(5121, "VEC4", 4, {0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 9, 0, 0})
      .floats("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 0.5, 0, 0, 0})
      .floats("MAT4", 2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                          1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1});
  return builder.text(
      R"("scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"skin":0,"translation":[99,0,0]},)"
      R"({"children":[2]},{"translation":[0,3,0]}],"skins":[)" +
      skin + R"(],"meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":0)" + attributes +
      "}}]}]");
}

TEST(AssetGltfNodes, SkinsAreBakedInTheirRestPose) {
  const std::string joined = R"(,"JOINTS_0":1,"WEIGHTS_0":2)";
  const Model model =
      read_text(with_skin(R"({"joints":[1,2],"inverseBindMatrices":3})", joined), Format::gltf);
  EXPECT_EQ(first_of(model).positions,
            (std::vector<glm::vec3>{{0, 0, 0}, {1, 2, 0}, {0, 1, 0}, {1, 3, 0}}));
  EXPECT_EQ(model.placements.at(0).transform, glm::dmat4(1.0));
  EXPECT_EQ(bounds(read_text(with_skin(R"({"joints":[1,2]})", joined), Format::gltf)).most.y, 4.0);
  const auto message = [&](const std::string& skin, const std::string& attributes) {
    return message_of(with_skin(skin, attributes), Format::gltf);
  };
  EXPECT_TRUE(holds(message(R"({"joints":[1]})", joined), "found joint 1 of a vertex"));
  EXPECT_TRUE(holds(message(R"({"joints":[1,7]})", joined), "/skins/0/joints/1: found 7"));
  EXPECT_TRUE(holds(message(R"({"joints":[]})", joined), "at least one joint"));
  EXPECT_TRUE(holds(message(R"({"joints":[1,2,0],"inverseBindMatrices":3})", joined),
                    "a MAT4 of floats for each joint"));
  EXPECT_TRUE(holds(message(R"({"joints":[1,2]})", ""), "a mesh without JOINTS_0"));
  EXPECT_TRUE(holds(message(R"({"joints":[1,2]})", R"(,"JOINTS_0":1)"), "weights for the joints"));
}

}  // namespace
}  // namespace aerostat::asset
