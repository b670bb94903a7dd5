#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>

#include "support.hpp"

namespace aerostat::asset {
namespace {

std::string header(const std::string& form, const std::string& more = {}) {
  return "ply\nformat " + form +
         " 1.0\ncomment made by hand\nobj_info none\n"
         "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n" +
         more;
}

constexpr const char* kFaces =
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
constexpr const char* kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

Model read_ply_text(const std::string& text) {
  return read_text(text, Format::ply);
}
std::string ply_message(const std::string& text, const ReadOptions& options = {}) {
  return message_of(text, Format::ply, options);
}

template <class Number>
std::string stored(Number number, bool is_big) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(Number));
  return is_big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

template <class Number>
std::string stored(std::initializer_list<double> numbers, bool is_big) {
  std::string bytes;
  for (const double number : numbers) bytes += stored(static_cast<Number>(number), is_big);
  return bytes;
}

TEST(AssetPly, TextAndBytesOfBothOrdersAreTheSame) {
  const Model text = read_ply_text(header("ascii") + kFaces + kSquare + "4 0 1 2 3\n");
  EXPECT_EQ(triangle_count(text), 2u);
  for (const bool is_big : {false, true}) {
    for (const char* ending : {"\n", "\r\n"}) {
      std::string head = header(is_big ? "binary_big_endian" : "binary_little_endian") + kFaces;
      for (std::size_t i = 0; (i = head.find('\n', i)) != std::string::npos;
           i += std::strlen(ending)) {
        head.replace(i, 1, ending);
      }
      const Model model =
          read_ply_text(head + stored<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, is_big) +
                        "\x04" + stored<std::int32_t>({0, 1, 2, 3}, is_big));
      EXPECT_EQ(first_of(model).positions, first_of(text).positions);
      EXPECT_EQ(first_of(model).triangles, first_of(text).triangles);
    }
  }
}

TEST(AssetPly, ListsAndNumbersOfAllTypesAreRead) {
  const std::string vertices =
      "ply\nformat binary_little_endian 1.0\nelement camera 1\nproperty list ushort double any\n"
      "property int8 other\nelement vertex 3\nproperty double x\nproperty int16 y\nproperty uint "
      "z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty ushort alpha\n"
      "property float s\nproperty float t\n"
      "element face 1\nproperty float quality\nproperty list uint32 short "
      "vertex_index\nend_header\n";
  std::string body = stored<std::uint16_t>({2}, false) + stored<double>({7, 8}, false) + "\x01";
  for (const double x : {0.5, 1.5, 2.5}) {
    body += stored<double>({x}, false) + stored<std::int16_t>({x * x - 3}, false) +
            stored<std::uint32_t>({9}, false) + std::string("\xff\x80\x00", 3) +
            stored<std::uint16_t>({32768}, false) + stored<float>({0.25, 0.75}, false);
  }
  body += stored<float>({1}, false) + stored<std::uint32_t>({3}, false) +
          stored<std::int16_t>({0, 1, 2}, false);
  const Model model = read_ply_text(vertices + body);
  EXPECT_EQ(first_of(model).positions.at(1), glm::vec3(1.5f, 0.0f, 9.0f));
  EXPECT_NEAR(first_of(model).colors.at(0).g, 0.2159f, 1e-4f);
  EXPECT_NEAR(first_of(model).colors.at(0).a, 0.5f, 1e-4f);
  EXPECT_EQ(first_of(model).uv.at(0), glm::vec2(0.25f, 0.25f));
  EXPECT_EQ(model.materials.at(0).base_color, glm::vec4(1.0f));
}

TEST(AssetPly, FacesMayHaveTextureCoordinatesAndColoursOfTheirOwn) {
  const std::string faces =
      "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  const Model model = read_ply_text(header("ascii", faces) + kSquare +
                                    "3 0 1 2 6 0 0 1 0 1 1 255 0 0\n3 0 2 3 0 0 255 0\n");
  EXPECT_EQ(first_of(model).positions.size(), 6u);
  EXPECT_EQ(first_of(model).uv.at(2), glm::vec2(1.0f, 0.0f));
  EXPECT_EQ(first_of(model).colors.at(0), glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
  EXPECT_EQ(first_of(model).colors.at(5), glm::vec4(0.0f, 1.0f, 0.0f, 1.0f));
}

TEST(AssetPly, SomeFacesMayHaveNoTextureCoordinates) {
  const Model model = read_ply_text(header("ascii",
                                           "element face 3\nproperty list uchar float texcoord\n"
                                           "property list uchar int vertex_indices\nend_header\n") +
                                    kSquare + "0 3 0 1 2\n6 0 0 1 0 1 1 3 0 1 2\n0 3 0 2 3\n");
  ASSERT_EQ(first_of(model).uv.size(), 9u);
  EXPECT_EQ(first_of(model).uv[2], glm::vec2(0.0f));
  EXPECT_EQ(first_of(model).uv[4], glm::vec2(1.0f, 1.0f));
  EXPECT_EQ(first_of(model).uv[8], glm::vec2(0.0f));
}

TEST(AssetPly, StripsTurnEveryOtherTriangle) {
  const Model model = read_ply_text(
      header("ascii", "element tristrips 1\nproperty list int int vertex_indices\nend_header\n") +
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n8 0 1 2 3 -1 0 1 2\n");
  ASSERT_EQ(triangle_count(model), 3u);
  const auto& p = first_of(model).positions;
  for (const auto& [a, b, c] : first_of(model).triangles) {
    EXPECT_GT(glm::cross(p[b] - p[a], p[c] - p[a]).z, 0.0f);
  }
}

TEST(AssetPly, FacesMayStandBeforeVertices) {
  const Model model = read_ply_text(
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
      "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n");
  EXPECT_EQ(triangle_count(model), 1u);
}

TEST(AssetPly, NumbersOfUtmKeepTheirPrecision) {
  const std::string file =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
      "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "487654.125 0 0\n487655.25 0 0\n487654.125 0 1\n3 0 1 2\n";
  EXPECT_EQ(read_ply_text(file).origin.x, 487655.0);
  EXPECT_EQ(bounds(read_ply_text(file)).size().x, 1.125);
}

TEST(AssetPly, TheTextureOfMeshLabIsRead) {
  const Folder folder;
  folder.write("t.png", png_2x1());
  std::string file = header("ascii") + kFaces + kSquare + "4 0 1 2 3\n";
  file.insert(file.find("element"), "comment TextureFile t.png\n");
  EXPECT_TRUE(read(folder.write("m.ply", file)).materials.at(0).base_color_texture);
  EXPECT_TRUE(holds(all_notes(read_ply_text(file)), "The texture is left out: there is no file"));
}

TEST(AssetPly, FaultsAreToldWithTheirPlace) {
  const std::string text = header("ascii") + kFaces;
  EXPECT_TRUE(holds(ply_message(header("ascii") + "end_header\n" + kSquare),
                    "found a point cloud of 4 vertices without faces"));
  EXPECT_TRUE(holds(ply_message(text + kSquare + "4 0 1 2 4\n"),
                    "face 0: found vertex 4, but there are 4"));
  EXPECT_TRUE(holds(ply_message(text + kSquare + "4 0 1 2 -1\n"), "line 16: found vertex -1"));
  EXPECT_TRUE(holds(ply_message(text + "0 0 0\n1,5 0 0\n"), "4 elements \"vertex\""));
  EXPECT_TRUE(holds(ply_message(text + "0 0 0\n1,5 0 0\n1 1 0\n0 1 0\n3 0 1 2\n"),
                    "line 13: found \"1,5\", expected a number whose decimal mark is a point"));
  EXPECT_TRUE(holds(ply_message(text + kSquare + "9 0 1 2\n"), "a list of 9 numbers"));
  EXPECT_TRUE(holds(ply_message("ply\nformat ascii 2.0\n"), "line 2: found \"2.0\""));
  EXPECT_TRUE(holds(ply_message("ply\nformat packed 1.0\n"), "\"packed\", expected ascii"));
  EXPECT_TRUE(holds(ply_message("ply\nproperty float x\n"), "an element before it"));
  EXPECT_TRUE(holds(ply_message("ply\nelement vertex -1\n"), "\"-1\", expected the number"));
  EXPECT_TRUE(holds(ply_message("ply\nelement vertex 1\nproperty list float int a\n"), "float"));
  EXPECT_TRUE(holds(ply_message("ply\nend_header\n"), "a line \"format\" before it"));
  EXPECT_TRUE(holds(ply_message("ply\nformat ascii 1.0\n"), "no line \"end_header\""));
  EXPECT_TRUE(holds(ply_message("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                "end_header\n1\n"),
                    "no properties x, y and z"));
  EXPECT_TRUE(holds(ply_message(header("binary_little_endian") + kFaces + std::string(40, '\0')),
                    "what 40 more bytes can hold"));
  EXPECT_TRUE(
      holds(ply_message("ply\nformat ascii 1.0\nelement nothing 99999999999\nend_header\n1"),
            "99999999999 elements"));
}

TEST(AssetPly, LimitsAreToldBeforeMemoryIsTaken) {
  ReadOptions options;
  options.limits.vertices = 3;
  EXPECT_TRUE(holds(ply_message(header("ascii") + kFaces + kSquare + "3 0 1 2\n", options),
                    "found 4 vertices, and at most 3 are read"));
}

}  // namespace
}  // namespace aerostat::asset
