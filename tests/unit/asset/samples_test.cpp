// Reads models of others. The numbers are those that trimesh 5.2.0 gives for the same files.

#include <cmath>
#include <ostream>
#include <string>

#include "support.hpp"

namespace aerostat::asset {
namespace {

struct Sample {
  const char* file;
  std::size_t triangles;  // placed
  std::size_t vertices;   // in all meshes
  glm::dvec3 least, most;
  double area;  // of what is placed, or 0 if that depends on how a bent polygon is cut
};

std::ostream& operator<<(std::ostream& out, const Sample& sample) {
  return out << sample.file;
}

const Sample kSamples[] = {
    {"alien.glb", 292, 637, {-0.241592, 0.0, -0.13}, {0.241592, 0.843184, 0.2}, 1.533885},
    {"building-small-a.glb", 452, 734, {-0.5, 0.0, -0.5}, {0.5, 0.95, 0.5}, 7.646524},
    {"nested.glb", 36, 72, {-1.16701, -2.3366, -0.269381}, {0.269381, 1.0, 0.269381}, 8.677204},
    {"cube_blender_uv.ply", 12, 24, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 6.0},
    {"nancolor.obj", 12, 8, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 6.0},
    {"polygonfaces.obj", 3, 5, {-500.0, 0.0, -500.0}, {500.0, 500.0, 500.0}, 0.0}};

Model read_sample(const std::string& file) {
  return read(AEROSTAT_SOURCE_DIR "/tests/data/models/" + file);
}

class AssetSamples : public testing::TestWithParam<Sample> {};

TEST_P(AssetSamples, AreReadAsAnotherReaderReadsThem) {
  const Sample& sample = GetParam();
  const Model model = read_sample(sample.file);
  EXPECT_EQ(placed_triangle_count(model), sample.triangles);
  std::size_t vertices = 0;
  double area = 0.0;
  for (const Placement& placement : model.placements) {
    for (const Primitive& primitive : model.meshes[placement.mesh].primitives) {
      vertices += primitive.positions.size();
      for (const auto& [a, b, c] : primitive.triangles) {
        const auto at = [&](std::uint32_t i) {
          return glm::dvec3(placement.transform * glm::dvec4(primitive.positions[i], 1.0));
        };
        area += 0.5 * glm::length(glm::cross(at(b) - at(a), at(c) - at(a)));
      }
    }
  }
  EXPECT_EQ(vertices, sample.vertices);
  const Bounds box = bounds(model);
  for (int i = 0; i < 3; ++i) {
    // The numbers have six digits.
    EXPECT_NEAR(box.least[i], sample.least[i], 1e-5 + 1e-5 * std::abs(sample.least[i]));
    EXPECT_NEAR(box.most[i], sample.most[i], 1e-5 + 1e-5 * std::abs(sample.most[i]));
  }
  if (sample.area > 0.0) {
    EXPECT_NEAR(area / sample.area, 1.0, 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, AssetSamples, testing::ValuesIn(kSamples));

TEST(AssetSamples, TheTransformOfTexturesIsApplied) {
  const Model model = read_sample("building-small-a.glb");
  ASSERT_EQ(model.textures.size(), 1u);
  EXPECT_EQ(model.textures[0].name, "Textures/colormap.png");
  EXPECT_EQ(model.textures[0].width, 512u);
  glm::vec2 least(9.0f), most(-9.0f);
  for (const glm::vec2& uv : first_of(model).uv) {
    least = glm::min(least, uv);
    most = glm::max(most, uv);
  }
  // trimesh gives 0.09375 to 0.71875 and, counted from the bottom row, 0.025 to 0.475.
  EXPECT_NEAR(least.x, 0.09375f, 1e-5f);
  EXPECT_NEAR(most.x, 0.71875f, 1e-5f);
  EXPECT_NEAR(least.y, 0.525f, 1e-5f);
  EXPECT_NEAR(most.y, 0.975f, 1e-5f);
}

}  // namespace
}  // namespace aerostat::asset
