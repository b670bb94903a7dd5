#include <cmath>
#include <string>

#include "support.hpp"

namespace aerostat::asset {
namespace {

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Model read_obj_text(const std::string& text, const ReadOptions& options = {}) {
  return read_text(text, Format::obj, options);
}

std::string obj_message(const std::string& text) {
  return message_of(text, Format::obj);
}

/// Returns the area of all triangles of a model.
double area_of(const Model& model) {
  double area = 0.0;
  for (const Primitive& primitive : model.meshes.at(0).primitives) {
    for (const auto& [a, b, c] : primitive.triangles) {
      const glm::dvec3 from(primitive.positions[a]);
      area += 0.5 * glm::length(glm::cross(glm::dvec3(primitive.positions[b]) - from,
                                           glm::dvec3(primitive.positions[c]) - from));
    }
  }
  return area;
}

TEST(AssetObj, CornersAreNumberedForwardsAndBackwards) {
  for (const char* face : {"f 1 2 3 4", "f -4 -3 -2 -1", "f 1// 2// 3// 4//", "f 1/ 2/ 3/ 4/",
                           "f 1 2 \\\n 3 4", "fo 1 2 3 4 # a square"}) {
    const Model model = read_obj_text(std::string(kSquare) + face);
    EXPECT_EQ(triangle_count(model), 2u) << face;
    EXPECT_EQ(first_of(model).positions.size(), 4u) << face;
    EXPECT_DOUBLE_EQ(area_of(model), 1.0) << face;
  }
}

TEST(AssetObj, LineEndsAndWhiteSpaceOfAllSystemsAreUnderstood) {
  for (const char* text :
       {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3",
        "  v\t0 0 0  \n\n#c\nv +1e0 0 0\nv 0 1. 0\nf  1\t2  3 "}) {
    EXPECT_EQ(triangle_count(read_obj_text(text)), 1u) << text;
  }
}

TEST(AssetObj, ConcavePolygonsAreCutInside) {
  // An arrow head whose fourth corner points inwards, and a U.
  const Model arrow = read_obj_text("v 0 0 0\nv 2 -2 0\nv 0 4 0\nv -2 -2 0\nf 1 2 3 4\n");
  EXPECT_EQ(triangle_count(arrow), 2u);
  EXPECT_DOUBLE_EQ(area_of(arrow), 8.0);
  const Model u = read_obj_text(
      "v 0 0 0\nv 0 0 3\nv 1 0 3\nv 1 0 1\nv 2 0 1\nv 2 0 3\nv 3 0 3\nv 3 0 0\nf 1 2 3 4 5 6 7 "
      "8\n");
  EXPECT_EQ(triangle_count(u), 6u);
  EXPECT_DOUBLE_EQ(area_of(u), 7.0);
  // A square with a square hole, joined by a pair of edges.
  const Model hole = read_obj_text(
      "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n"
      "f 1 2 3 4 1 5 6 7 8 5\n");
  EXPECT_DOUBLE_EQ(area_of(hole), 8.0);
}

TEST(AssetObj, PolygonsThatCrossThemselvesTakeNoEndlessTime) {
  std::string star, face = "f";
  for (int i = 0; i < 4000; ++i) {
    const double angle = i * 2.0;  // the outline turns around the middle many times
    star += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  EXPECT_EQ(triangle_count(read_obj_text(star + face)), 3998u);
}

TEST(AssetObj, WindingStaysAsItIs) {
  for (const char* face : {"f 1 2 3 4", "f 4 3 2 1"}) {
    const Model model =
        read_obj_text("v 0 0 0\nv 2 -2 0\nv 0 4 0\nv -2 -2 0\n" + std::string(face));
    for (const auto& [a, b, c] : first_of(model).triangles) {
      const auto& p = first_of(model).positions;
      const float side = glm::cross(p[b] - p[a], p[c] - p[a]).z;
      EXPECT_EQ(side > 0.0f, face[2] == '1') << face;
    }
  }
}

TEST(AssetObj, TextureCoordinatesCountFromTheTopRow) {
  const Model model =
      read_obj_text(std::string(kSquare) + "vt 0.25 0.75\nvt 1 0\nvt 0\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(first_of(model).uv.at(0), glm::vec2(0.25f, 0.25f));
  EXPECT_EQ(first_of(model).uv.at(1), glm::vec2(1.0f, 1.0f));
  EXPECT_EQ(first_of(model).uv.at(2), glm::vec2(0.0f, 1.0f));
}

TEST(AssetObj, CornersWithOtherAttributesAreOtherVertices) {
  const Model model = read_obj_text(std::string(kSquare) +
                                    "vt 0 0\nvt 1 1\nvn 0 0 2\n"
                                    "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/2/1 4/1/1\nf 1 2 3\n");
  ASSERT_EQ(model.meshes[0].primitives.size(), 2u);  // faces with and without attributes
  EXPECT_EQ(first_of(model).positions.size(), 5u);
  EXPECT_EQ(first_of(model).normals.at(0), glm::vec3(0.0f, 0.0f, 1.0f));
  EXPECT_TRUE(model.meshes[0].primitives[1].normals.empty());
}

TEST(AssetObj, SmoothingGroupsGetNormals) {
  const std::string roof = "v 0 0 0\nv 0 0 1\nv -1 -1 0\nv 1 -1 0\n";
  const Model smooth = read_obj_text(roof + "s 1\nf 1 3 2\nf 1 2 4\n");
  EXPECT_NEAR(first_of(smooth).normals.at(0).y, 1.0f, 1e-6f);
  EXPECT_TRUE(first_of(read_obj_text(roof + "s off\nf 1 3 2\nf 1 2 4\n")).normals.empty());
}

TEST(AssetObj, ColoursOfVerticesAreReadAndMadeLinear) {
  const Model model = read_obj_text("v 0 0 0 1 0.5 0\nv 1 0 0 nan 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_NEAR(first_of(model).colors.at(0).g, 0.2140f, 1e-4f);
  EXPECT_EQ(first_of(model).colors.at(1), glm::vec4(1.0f));
  EXPECT_EQ(first_of(model).colors.at(2), glm::vec4(1.0f));
  EXPECT_TRUE(holds(all_notes(model), "1 colour"));
  EXPECT_EQ(model.materials.at(0).base_color, glm::vec4(1.0f));
  const Model bytes = read_obj_text("v 0 0 0 255 0 0\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n");
  EXPECT_FLOAT_EQ(first_of(bytes).colors.at(0).r, 1.0f);
  const Model weights = read_obj_text("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n");
  EXPECT_TRUE(first_of(weights).colors.empty());
}

TEST(AssetObj, NumbersOfUtmKeepTheirPrecision) {
  const Model model = read_obj_text(
      "v 487654.125 5212345.25 812.5\nv 487655.250 5212345.25 812.5\n"
      "v 487654.125 5212346.5 812.5\nf 1 2 3\n");
  EXPECT_EQ(model.origin, glm::dvec3(487655.0, 5212346.0, 0.0));
  EXPECT_EQ(bounds(model).size(), glm::dvec3(1.125, 1.25, 0.0));

  ReadOptions options;
  options.up = Axis::z;
  const Model turned = read_obj_text(
      "v 487654.125 5212345.25 812.5\nv 487655.250 5212345.25 812.5\n"
      "v 487654.125 5212346.5 812.5\nf 1 2 3\n",
      options);
  EXPECT_EQ(turned.origin, glm::dvec3(487655.0, 0.0, -5212346.0));
  EXPECT_EQ(bounds(turned).size(), glm::dvec3(1.125, 0.0, 1.25));
}

TEST(AssetObj, FaultsNameTheLineAndWhatWasExpected) {
  const std::string square(kSquare);
  EXPECT_TRUE(
      holds(obj_message(square + "f 1 2 5\n"), "line 5: found vertex 5, but the file has 4"));
  EXPECT_TRUE(holds(obj_message(square + "f 0 1 2\n"), "line 5: found \"0\", expected numbers"));
  EXPECT_TRUE(holds(obj_message(square + "f 1 2 -5\n"), "-1 to -4"));
  EXPECT_TRUE(holds(obj_message(square + "f 1/1 2/1 3/1\n"), "texture coordinate 1"));
  EXPECT_TRUE(holds(obj_message(square + "f 1//9 2//1 3//1\n"), "normal 9"));
  EXPECT_TRUE(holds(obj_message(square + "f 1.5 2 3\n"), "\"1.5\""));
  EXPECT_TRUE(holds(obj_message("v 1,5 0 0\n"),
                    "line 1: found \"1,5\", expected a number whose "
                    "decimal mark is a point and not a comma"));
  EXPECT_TRUE(holds(obj_message("v 1 2\n"), "line 1: the line ends where a number is expected"));
  EXPECT_TRUE(holds(obj_message("v 0 0 0\n"), "found 1 vertex without faces"));
  EXPECT_TRUE(holds(obj_message(""), "neither vertices nor faces"));
  EXPECT_TRUE(holds(obj_message(square + "f 1 1 1\n"), "no triangle that can be drawn"));
  EXPECT_TRUE(holds(obj_message("x"), "/nowhere/model: "));
}

TEST(AssetObj, WhatCannotBeDrawnIsNoted) {
  const Model model = read_obj_text(std::string(kSquare) +
                                    "v inf 0 0\nl 1 2\np 1\nf 1 2\ncurv 0 1 1 2\n"
                                    "f 1 2 5\nf 1 2 2\nf 1 2 3\n");
  EXPECT_EQ(triangle_count(model), 1u);
  const std::string notes = all_notes(model);
  EXPECT_TRUE(holds(notes, "Left out: 2 lines and points.\n"));
  EXPECT_TRUE(holds(notes, "Left out: 1 face with fewer than three corners.\n"));
  EXPECT_TRUE(holds(notes, "Left out: 1 curve or curved surface.\n"));
  EXPECT_TRUE(holds(notes, "positions that are not finite: 1 triangle.\n"));
  EXPECT_TRUE(holds(notes, "two corners lie at one place: 1 triangle.\n"));
}

TEST(AssetObj, LimitsAreToldBeforeTheyArePassed) {
  ReadOptions options;
  options.limits.vertices = 3;
  EXPECT_TRUE(
      holds(message_of(kSquare, Format::obj, options), "line 4: found more than 3 vertices"));
  options.limits.vertices = 4;
  options.limits.triangles = 1;
  EXPECT_TRUE(holds(message_of(std::string(kSquare) + "f 1 2 3 4", Format::obj, options),
                    "found 2 triangles, and at most 1 are read of a model"));
  options = {};
  options.limits.materials = 0;
  EXPECT_TRUE(holds(message_of(std::string(kSquare) + "f 1 2 3", Format::obj, options),
                    "faces of yet another material, expected at most 0"));
  std::string libraries;
  for (int i = 0; i < 101; ++i) libraries += "mtllib a\n";
  EXPECT_TRUE(
      holds(obj_message(libraries), "line 101: found one more mtllib, expected at most 100"));
  std::string round(kSquare);
  round += "f";
  for (int i = 0; i < 5000; ++i) round += " 1";
  EXPECT_TRUE(holds(obj_message(round), "at most 4096"));
}

}  // namespace
}  // namespace aerostat::asset
