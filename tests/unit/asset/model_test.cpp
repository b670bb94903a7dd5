#include "asset/model.hpp"

#include <gtest/gtest.h>

namespace aerostat::asset {
namespace {

TEST(AssetModel, BoundsHoldWhatIsPlaced) {
  Model model;
  Primitive triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  triangle.triangles = {{0, 1, 2}};
  model.meshes = {{"", {triangle}}};
  EXPECT_TRUE(bounds(model).empty());

  Placement mirrored;
  mirrored.transform[0][0] = -1.0;
  Placement raised;
  raised.transform[3] = glm::dvec4(0.0, 10.0, 0.0, 1.0);
  model.placements = {mirrored, raised};
  EXPECT_EQ(bounds(model).least, glm::dvec3(-1.0, 0.0, 0.0));
  EXPECT_EQ(bounds(model).most, glm::dvec3(1.0, 12.0, 0.0));
  EXPECT_EQ(triangle_count(model), 1u);
  EXPECT_EQ(placed_triangle_count(model), 2u);
}

}  // namespace
}  // namespace aerostat::asset
