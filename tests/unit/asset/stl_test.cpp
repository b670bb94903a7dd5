#include <cstdint>
#include <cstring>
#include <string>

#include "support.hpp"

namespace aerostat::asset {
namespace {

constexpr const char* kText =
    "solid A name\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
    "   vertex 0 2 0\n  endloop\n endfacet\n"
    "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1e1 0 0\nVERTEX 0 2 "
    "3\nENDLOOP\nENDFACET\n"
    "endsolid A name\nsolid another\nendsolid another\n";

std::string binary(std::uint32_t count, const std::string& begin = {}) {
  std::string bytes = begin + std::string(80 - begin.size(), ' ');
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  const float triangle[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, 3};
  for (std::uint32_t i = 0; i < count; ++i) {
    bytes.append(reinterpret_cast<const char*>(triangle), sizeof(triangle)).append(2, '\0');
  }
  return bytes;
}

std::string stl_message(const std::string& text) {
  return message_of(text, Format::stl);
}

TEST(AssetStl, TextAndBytesAreRead) {
  const Model text = read_text(kText, Format::stl);
  EXPECT_EQ(triangle_count(text), 2u);
  EXPECT_EQ(text.meshes[0].name, "A name");
  EXPECT_EQ(bounds(text).most, glm::dvec3(10.0, 2.0, 3.0));
  EXPECT_TRUE(first_of(text).normals.empty());  // facets are flat
  for (const char* begin : {"", "solid "}) {
    const Model model = read_text(binary(3, begin), Format::stl);
    EXPECT_EQ(triangle_count(model), 3u);
    EXPECT_EQ(bounds(model).most, glm::dvec3(1.0, 2.0, 3.0));
  }
  EXPECT_TRUE(holds(all_notes(read_text(binary(1) + "more", Format::stl)), "4 bytes behind"));
}

TEST(AssetStl, ZPointsUpOnRequest) {
  ReadOptions options;
  options.up = Axis::z;
  const Model model = read_text(kText, Format::stl, options);
  EXPECT_EQ(bounds(model).least, glm::dvec3(0.0, 0.0, -2.0));
  EXPECT_EQ(bounds(model).most, glm::dvec3(10.0, 3.0, 0.0));
}

TEST(AssetStl, FaultsAreToldWithTheirPlace) {
  EXPECT_TRUE(holds(stl_message("solid a\nfacet\nvertex 0 0,5 0\n"), "line 3: found \"0,5\""));
  EXPECT_TRUE(holds(stl_message("solid a\nfacet\nvertex 0 0 0\nendloop\n"),
                    "line 4: found a facet of 1 vertex, expected three"));
  EXPECT_TRUE(holds(stl_message("solid a\nvertex 0 0 0\n"), "the file ends inside of a facet"));
  EXPECT_TRUE(holds(stl_message("solid a\nfacets\n"), "line 2: found \"facets\""));
  EXPECT_TRUE(holds(stl_message("solid a\nendsolid\n"), "no triangle that can be drawn"));
  EXPECT_TRUE(holds(stl_message("abc"), "the file has 3 bytes"));
  EXPECT_TRUE(
      holds(stl_message(binary(2).substr(0, 150)), "150 bytes, but its 2 triangles need 184"));
}

TEST(AssetStl, LimitsAreToldBeforeMemoryIsTaken) {
  ReadOptions options;
  options.limits.triangles = 2;
  EXPECT_TRUE(holds(message_of(binary(3), Format::stl, options),
                    "found 3 triangles, and at most 2 are read"));
}

}  // namespace
}  // namespace aerostat::asset
