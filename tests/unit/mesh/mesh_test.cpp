#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mesh/export.hpp"
#include "mesh/grid_mesh.hpp"

namespace aerostat::mesh {
namespace {

TriangleMesh quad(float z, bool colored) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, z}, {1.5f, 0, z}, {1.5f, 2, z}, {0, 2, z}};
  mesh.normals.assign(4, vec3(0, 0, 1));
  if (colored) mesh.colors = {{0, 0, 0}, {1, 0, 0}, {0.5f, 0.5f, 0.5f}, {2.0f, -1.0f, 0.0031308f}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(Mesh, AppendRaisesIndicesAndFillsColors) {
  TriangleMesh whole = quad(0, false);
  append(whole, quad(1, true));
  append(whole, quad(2, false));
  ASSERT_EQ(whole.positions.size(), 12u);
  ASSERT_EQ(whole.colors.size(), 12u);
  EXPECT_EQ(whole.colors[0], vec3(1));
  EXPECT_EQ(whole.colors[5], vec3(1, 0, 0));
  EXPECT_EQ(whole.colors[11], vec3(1));
  EXPECT_EQ(whole.triangles[3], uvec3(4, 6, 7));
  EXPECT_EQ(whole.triangles[5], uvec3(8, 10, 11));
  EXPECT_NO_THROW(check(whole, "whole"));
}

TEST(Mesh, AppendWithoutColorsStaysWithout) {
  TriangleMesh whole;
  append(whole, quad(0, false));
  append(whole, quad(1, false));
  EXPECT_TRUE(whole.colors.empty());
  EXPECT_EQ(whole.triangles.size(), 4u);
}

TEST(Mesh, NormalsAreWeightedByArea) {
  TriangleMesh mesh;
  // Triangles with the areas 2 (facing +z) and 1 (facing +x) meet in vertex 0. Vertex 5 belongs to
  // no triangle.
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 1, -2}, {0, 0, -2}, {5, 5, 5}};
  mesh.triangles = {{0, 1, 2}, {0, 4, 3}};
  mesh.triangles[1] = {0, 4, 3};
  compute_normals(mesh);
  ASSERT_EQ(mesh.normals.size(), 6u);
  const vec3 side = glm::normalize(glm::cross(mesh.positions[4], mesh.positions[3]));
  const vec3 expected = glm::normalize(2.0f * vec3(0, 0, 1) + 1.0f * side);
  EXPECT_NEAR(glm::distance(mesh.normals[0], expected), 0.0f, 1e-6f);
  EXPECT_EQ(mesh.normals[1], vec3(0, 0, 1));
  EXPECT_EQ(mesh.normals[5], vec3(0, 1, 0));
}

TEST(Mesh, CheckNamesTheFault) {
  TriangleMesh mesh = quad(0, true);
  mesh.triangles.emplace_back(0, 1, 4);
  try {
    check(mesh, "sail");
    FAIL() << "an index out of range was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::internal);
    EXPECT_NE(std::string(error.what()).find("sail"), std::string::npos);
  }
  mesh = quad(0, true);
  mesh.colors.pop_back();
  EXPECT_THROW(check(mesh, "sail"), Error);
  mesh = quad(0, false);
  mesh.normals.pop_back();
  EXPECT_THROW(check(mesh, "sail"), Error);
}

struct Ply {
  std::vector<std::string> header;
  std::size_t vertices = 0, faces = 0;
  std::string body;

  explicit Ply(const std::vector<std::uint8_t>& bytes) {
    const std::string text(bytes.begin(), bytes.end());
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line) && line != "end_header";) {
      header.push_back(line);
      std::sscanf(line.c_str(), "element vertex %zu", &vertices);
      std::sscanf(line.c_str(), "element face %zu", &faces);
    }
    body = text.substr(text.find("end_header\n") + 11);
  }

  template <typename T>
  T at(std::size_t offset) const {
    T value;
    std::memcpy(&value, body.data() + offset, sizeof value);
    return value;
  }
};

TEST(Ply, ReadsBackExactly) {
  const TriangleMesh first = quad(0.1f, true), second = quad(-7, false);
  const ExportObject objects[] = {{3, "envelope", &first}, {7, "frame", &second}};
  const Ply ply(ply_bytes(objects));
  EXPECT_EQ(ply.header[0], "ply");
  EXPECT_EQ(ply.header[1], "format binary_little_endian 1.0");
  ASSERT_EQ(ply.vertices, 8u);
  ASSERT_EQ(ply.faces, 4u);
  ASSERT_EQ(ply.body.size(), 8u * 39 + 4 * 17);
  constexpr std::size_t kColored = 24 + 3 + 12;
  EXPECT_EQ(ply.at<vec3>(2 * kColored), first.positions[2]);
  EXPECT_EQ(ply.at<vec3>(5 * kColored), second.positions[1]);
  EXPECT_EQ(ply.at<vec3>(5 * kColored + 12), vec3(0, 0, 1));
  const auto rgb = [&](std::size_t vertex, std::size_t channel) {
    return ply.at<std::uint8_t>(vertex * kColored + 24 + channel);
  };
  EXPECT_EQ(rgb(0, 0), 0);
  EXPECT_EQ(rgb(1, 0), 255);
  // The linear value is 0.5.
  EXPECT_EQ(rgb(2, 1), 188);
  EXPECT_EQ(rgb(3, 0), 255);
  EXPECT_EQ(rgb(3, 1), 0);
  EXPECT_EQ(rgb(3, 2), 10);
  EXPECT_EQ(ply.at<vec3>(3 * kColored + 27), first.colors[3]) << "as exact floats";
  // The second object has no colours.
  EXPECT_EQ(rgb(6, 1), 255);
  const std::size_t faces = 8 * kColored;
  EXPECT_EQ(ply.at<std::uint8_t>(faces), 3);
  EXPECT_EQ(ply.at<uvec3>(faces + 17 + 1), uvec3(0, 2, 3));
  EXPECT_EQ(ply.at<std::uint32_t>(faces + 17 + 13), 3u);
  EXPECT_EQ(ply.at<uvec3>(faces + 3 * 17 + 1), uvec3(4, 6, 7));
  EXPECT_EQ(ply.at<std::uint32_t>(faces + 3 * 17 + 13), 7u);
}

TEST(Export, MultipliesColorsByThatOfTheObject) {
  const TriangleMesh first = quad(0, true), second = quad(1, false);
  const vec3 factor(0.5f, 0.25f, 0.125f);
  const ExportObject objects[] = {{1, "land", &first, "ground", factor},
                                  {2, "sea", &second, "water", factor}};
  const Ply ply(ply_bytes(objects));
  EXPECT_EQ(ply.at<vec3>(2 * 39 + 27), factor * first.colors[2]);
  EXPECT_EQ(ply.at<vec3>(6 * 39 + 27), factor);
  const std::vector<std::uint8_t> bytes = obj_bytes(objects, dvec3(0.0), "world.mtl");
  const std::string obj(bytes.begin(), bytes.end());
  for (const char* line : {"\nmtllib world.mtl\n", "\no land\nusemtl ground\n",
                           "\no sea\nusemtl water\n", " 0.5 0.25 0.125\n"}) {
    EXPECT_NE(obj.find(line), std::string::npos) << line;
  }
}

/// A right triangle of one colour with two sides of a size.
TriangleMesh triangle(float size, const vec3& color) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
  mesh.normals.assign(3, vec3(0, 0, 1));
  mesh.colors.assign(3, color);
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TEST(Mtl, HasMeansByArea) {
  const TriangleMesh small = triangle(1.0f, vec3(1.0f, 0.0f, 0.5f)),
                     large = triangle(2.0f, vec3(0.0f, 0.5f, 0.5f));
  const ExportObject objects[] = {
      {1, "a", &small, "cloth"}, {2, "b", &large, "cloth"}, {3, "c", &small, "wood", vec3(0.5f)}};
  const std::vector<std::uint8_t> bytes = mtl_bytes(objects);
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_NE(text.find("newmtl cloth\nKd 0.2 0.4 0.5\n"), std::string::npos) << text;
  EXPECT_NE(text.find("newmtl wood\nKd 0.5 0 0.25\n"), std::string::npos) << text;
}

TEST(Ply, LeavesColorsOutWhereThereAreNone) {
  const TriangleMesh mesh = quad(0, false);
  const ExportObject objects[] = {{1, "terrain", &mesh}};
  const Ply ply(ply_bytes(objects));
  for (const std::string& line : ply.header) EXPECT_EQ(line.find("red"), std::string::npos);
  EXPECT_EQ(ply.body.size(), 4u * 24 + 2 * 17);
}

TEST(Ply, OfNothingIsStillAFile) {
  const Ply ply(ply_bytes({}));
  EXPECT_EQ(ply.vertices, 0u);
  EXPECT_EQ(ply.faces, 0u);
  EXPECT_TRUE(ply.body.empty());
}

TEST(Export, SaysWhatPositionsCountFrom) {
  const TriangleMesh mesh = quad(0, false);
  const ExportObject objects[] = {{1, "terrain", &mesh}};
  const auto holds = [](const std::vector<std::uint8_t>& bytes, const std::string& text) {
    return std::string(bytes.begin(), bytes.end()).find(text) != std::string::npos;
  };
  const dvec3 origin(1e6 + 0.1, 0.0, -12345678.25);
  EXPECT_TRUE(holds(ply_bytes(objects, origin), "\ncomment origin 1000000.1 0 -12345678.25\n"));
  EXPECT_TRUE(holds(obj_bytes(objects, origin), "\n# origin 1000000.1 0 -12345678.25\n"));
  EXPECT_EQ(Ply(ply_bytes(objects, origin)).body, Ply(ply_bytes(objects)).body);
  EXPECT_FALSE(holds(ply_bytes(objects), "origin"));
  EXPECT_FALSE(holds(obj_bytes(objects), "origin"));
}

TEST(Ply, RefusesABrokenMesh) {
  TriangleMesh mesh = quad(0, false);
  mesh.triangles[0].x = 9;
  const ExportObject objects[] = {{1, "terrain", &mesh}};
  EXPECT_THROW(ply_bytes(objects), Error);
  EXPECT_THROW(obj_bytes(objects), Error);
}

TEST(Obj, ReadsBackExactly) {
  TriangleMesh first = quad(1.0f / 3.0f, true);
  first.positions[1] = {-1.17549435e-38f, 1e20f, 12345.6789f};
  const TriangleMesh second = quad(-7, false);
  const ExportObject objects[] = {{3, "envelope", &first}, {7, "frame", &second}};
  const std::vector<std::uint8_t> bytes = obj_bytes(objects);
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::vector<std::string> names;
  std::vector<vec3> positions, normals;
  std::vector<uvec3> faces;
  for (std::string line; std::getline(lines, line);) {
    vec3 v;
    uvec3 a, b;
    char name[32];
    if (std::sscanf(line.c_str(), "v %f %f %f", &v.x, &v.y, &v.z) == 3) positions.push_back(v);
    if (std::sscanf(line.c_str(), "vn %f %f %f", &v.x, &v.y, &v.z) == 3) normals.push_back(v);
    if (std::sscanf(line.c_str(), "o %31s", name) == 1) names.emplace_back(name);
    if (std::sscanf(line.c_str(), "f %u//%u %u//%u %u//%u", &a.x, &b.x, &a.y, &b.y, &a.z, &b.z) ==
        6) {
      EXPECT_EQ(a, b);
      faces.push_back(a);
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{"envelope", "frame"}));
  ASSERT_EQ(positions.size(), 8u);
  ASSERT_EQ(normals.size(), 8u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(positions[i], first.positions[i]);
  EXPECT_EQ(positions[6], second.positions[2]);
  EXPECT_EQ(faces, (std::vector<uvec3>{{1, 2, 3}, {1, 3, 4}, {5, 6, 7}, {5, 7, 8}}));
}

TEST(GridMesh, RowsAreSetAsVerticesAre) {
  // The grid has 41 x 12 vertices, so that there are whole vectors, a rest and partly filled blocks
  // at the rim.
  std::vector<float> x(41), z(12);
  std::iota(x.begin(), x.end(), 0.0f);
  std::iota(z.begin(), z.end(), 0.0f);
  GridMesh one_by_one(x, z), by_rows(x, z);
  for (std::uint32_t j = 0; j < z.size(); ++j) {
    std::vector<float> heights(x.size());
    std::vector<vec3> normals(x.size());
    for (std::uint32_t i = 0; i < x.size(); ++i) {
      const auto wave = static_cast<float>(i * 7 + j * 13);
      heights[i] = 100.0f * std::sin(wave);
      normals[i] = glm::normalize(vec3(2.0f * std::cos(wave), 1.0f, 3.0f * std::sin(2.0f * wave)));
      one_by_one.set(i, j, heights[i], normals[i]);
    }
    by_rows.set_row(j, heights, normals);
  }
  ASSERT_EQ(by_rows.words().size(), one_by_one.words().size());
  EXPECT_EQ(std::memcmp(by_rows.words().data(), one_by_one.words().data(),
                        one_by_one.words().size_bytes()),
            0);
}

TEST(GridMesh, CellsAreSplitAlongTheLessSteepDiagonal) {
  const std::vector<float> lines{0.0f, 1.0f};
  for (const std::uint32_t raised : {0u, 1u, 2u, 3u}) {
    GridMesh grid(lines, lines);
    for (std::uint32_t vertex = 0; vertex < 4; ++vertex) {
      grid.set(vertex % 2, vertex / 2, vertex == raised ? 1.0f : 0.0f, vec3(0, 1, 0));
    }
    // The level diagonal is the one without the raised corner, and both triangles have its ends.
    for (const uvec3& t : to_triangles(grid).triangles) {
      for (std::uint32_t vertex = 0; vertex < 4; ++vertex) {
        const bool on_diagonal = vertex != raised && vertex != 3 - raised;
        const bool has = t.x == vertex || t.y == vertex || t.z == vertex;
        EXPECT_TRUE(has || !on_diagonal) << "corner " << raised << " is raised";
      }
    }
  }
}

}  // namespace
}  // namespace aerostat::mesh
