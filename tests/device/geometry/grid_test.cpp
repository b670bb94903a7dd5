// Tests that the height grid gives exactly the same hits as the same triangles in a soup.
#include <cmath>
#include <ostream>
#include <random>
#include <tuple>

#include "height_grid.h"
#include "reference_meshes.hpp"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

struct GridShape {
  std::uint32_t columns, rows;
  float height;
  /// The width of the widest cell divided by that of the narrowest.
  float stretch;
};

void PrintTo(const GridShape& shape, std::ostream* out) {
  *out << shape.columns << " x " << shape.rows << ", heights " << shape.height;
}

std::vector<float> graded_lines(std::uint32_t cells, float stretch) {
  std::vector<float> lines{0.0f};
  for (std::uint32_t k = 0; k < cells; ++k) {
    const float t =
        std::fabs(2.0f * (static_cast<float>(k) + 0.5f) / static_cast<float>(cells) - 1.0f);
    lines.push_back(lines.back() + 1.0f + (stretch - 1.0f) * t * t);
  }
  const float whole = lines.back();
  for (float& line : lines) line = 2.0f * line / whole - 1.0f;
  return lines;
}

mesh::GridMesh bumpy(const GridShape& shape) {
  mesh::GridMesh grid(graded_lines(shape.columns, shape.stretch),
                      graded_lines(shape.rows, shape.stretch));
  std::mt19937 random(31);
  for (std::uint32_t j = 0; j <= grid.rows(); ++j) {
    for (std::uint32_t i = 0; i <= grid.columns(); ++i) {
      const float wave = std::sin(5.0f * grid.x(i)) * std::cos(4.0f * grid.z(j));
      const float rough = 0.2f * random_point(random, 1.0f).y;
      grid.set(i, j, shape.height * (wave + rough), vec3(0.0f, 1.0f, 0.0f));
    }
  }
  return grid;
}

Soup soup_of(const mesh::GridMesh& grid) {
  const mesh::TriangleMesh mesh = mesh::to_triangles(grid);
  return {mesh.positions, mesh.triangles};
}

/// Returns the number of a ground triangle in the order of to_triangles().
std::uint32_t index_of(std::uint32_t number, const mesh::GridMesh& grid) {
  const std::uint32_t i = number >> AERO_GRID_COLUMN_SHIFT & AERO_GRID_CELL_MASK;
  const std::uint32_t j = number >> AERO_GRID_ROW_SHIFT & AERO_GRID_CELL_MASK;
  return 2 * (j * grid.columns() + i) + (number & 1u);
}

/// Returns bundles of rays from a camera, along axes, from within the boxes, and in every
/// direction.
std::vector<Ray> rays_at(const mesh::GridMesh& grid, std::size_t bundles) {
  std::mt19937 random(32);
  std::vector<Ray> rays;
  for (std::size_t b = 0; b < bundles; ++b) {
    const vec3 eye = random_point(random, b % 3 == 0 ? 0.3f : 2.0f);
    const vec3 axis = random_direction(random);
    for (int k = 0; k < 64; ++k) {
      const auto i = static_cast<std::uint32_t>(random() % (grid.columns() + 1));
      const auto j = static_cast<std::uint32_t>(random() % (grid.rows() + 1));
      const vec3 target = b % 5 == 4 ? grid.position(i, j) : random_point(random, 0.9f);
      switch (b % 4) {
        case 0:
          rays.push_back({eye, random_direction(random)});
          break;
        case 1:
          rays.push_back(ray_towards(eye, dvec3(0.1f * target)));
          break;
        case 2:
          rays.push_back(ray_towards(eye + 0.01f * random_point(random, 1.0f), dvec3(target)));
          break;
        default:
          rays.push_back({target - 2.0f * axis, axis});
          if (k % 7 == 0) rays.back() = {target + vec3(0.0f, 3.0f, 0.0f), vec3(0.0f, -1.0f, 0.0f)};
          if (k % 11 == 0) rays.back().t_max = k % 2 == 0 ? -1.0f : 1.0f;
      }
    }
  }
  return rays;
}

class GridTrace : public testing::TestWithParam<std::tuple<GridShape, int>> {};

TEST_P(GridTrace, MeetsTheSameTrianglesAsASoupToTheBit) {
  const auto& [shape, lanes] = GetParam();
  const mesh::GridMesh grid = bumpy(shape);
  const TracedMesh traced(grid), reference(soup_of(grid));
  const std::vector<Ray> rays = rays_at(grid, 40);
  const auto hits = traced.trace_bundles(rays, lanes), expected = reference.trace_bundles(rays, 1);
  std::size_t met = 0, others = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(hits[i].t, expected[i].t) << "ray " << i;
    if (!expected[i].met()) continue;
    ++met;
    // If two triangles are at the same distance, each tree takes the one that comes first in its
    // own order.
    if (index_of(hits[i].slot, grid) != reference.tree().order[expected[i].slot]) {
      ++others;
      continue;
    }
    ASSERT_EQ(hits[i].u, expected[i].u) << "ray " << i;
    ASSERT_EQ(hits[i].v, expected[i].v) << "ray " << i;
  }
  EXPECT_GT(met, rays.size() / 10);
  EXPECT_LT(others, met / 5);
  const auto occluded = traced.trace_bundles(rays, lanes, Wanted::any);
  for (std::size_t i = 0; i < rays.size(); ++i)
    ASSERT_EQ(occluded[i].met(), expected[i].met()) << "ray " << i;
}

// Tests frustums of one direction, such as the sun's, frustums of one origin, and rays of all
// directions.
TEST_P(GridTrace, FromAboveMeetsWhatARayEnters) {
  const auto& [shape, lanes] = GetParam();
  const mesh::GridMesh grid = bumpy(shape);
  const mesh::TriangleMesh triangles = mesh::to_triangles(grid);
  const std::vector<Ray> rays = rays_at(grid, 40);
  const auto hits = TracedMesh(grid).trace_bundles(rays, lanes, Wanted::any_from_above);
  std::size_t entering = 0, sure = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const int expected = rays[i].t_max < 0.0f ? 0 : enters(triangles, rays[i]);
    if (expected < 0) continue;
    ++sure;
    entering += expected == 1 ? 1 : 0;
    ASSERT_EQ(hits[i].met(), expected == 1) << "ray " << i;
  }
  EXPECT_GT(sure, rays.size() * 8 / 10);
  EXPECT_GT(entering, rays.size() / 20);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, GridTrace,
    testing::Combine(testing::Values(GridShape{1, 1, 0.3f, 1.0f}, GridShape{2, 9, 0.3f, 3.0f},
                                     GridShape{33, 17, 0.3f, 6.0f}, GridShape{40, 40, 1.0f, 1.0f},
                                     GridShape{50, 25, 0.05f, 20.0f},
                                     GridShape{16, 16, 0.0f, 2.0f}),
                     testing::Values(1, 4, 8, 16)));

}  // namespace
}  // namespace aerostat::test
