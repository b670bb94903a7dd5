#include <cmath>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "bvh/grid.hpp"
#include "bvh_inspect.hpp"
#include "bvh_meshes.hpp"
#include "bvh_tracer.hpp"
#include "core/error.hpp"

namespace aerostat {
namespace {

using bvh::Bvh;
using test::Soup;

struct Size {
  std::uint32_t columns, rows;
};

void PrintTo(const Size& size, std::ostream* out) {
  *out << size.columns << " x " << size.rows;
}

// A bumpy grid over [-1, 1]^2 whose lines draw apart towards the border, with diagonals of both
// kinds.
Soup grid(const Size& size, float height = 0.3f) {
  Soup soup;
  const auto line = [](std::uint32_t i, std::uint32_t cells) {
    const float t = 2.0f * static_cast<float>(i) / static_cast<float>(cells) - 1.0f;
    return t * (0.3f + 0.7f * t * t);
  };
  for (std::uint32_t j = 0; j <= size.rows; ++j) {
    for (std::uint32_t i = 0; i <= size.columns; ++i) {
      const float x = line(i, size.columns), z = line(j, size.rows);
      const float y = std::sin(5.0f * x) * std::cos(4.0f * z) + 0.2f * std::sin(31.0f * x * z);
      soup.positions.push_back({x, height * y, z});
    }
  }
  const std::uint32_t row = size.columns + 1;
  for (std::uint32_t j = 0; j < size.rows; ++j) {
    for (std::uint32_t i = 0; i < size.columns; ++i) {
      const std::uint32_t a = j * row + i, b = a + 1, c = a + row, d = c + 1;
      const bool falling = (i * 7 + j * 3) % 5 < 2;
      soup.triangles.push_back(falling ? uvec3(a, c, d) : uvec3(a, c, b));
      soup.triangles.push_back(falling ? uvec3(a, d, b) : uvec3(b, c, d));
    }
  }
  return soup;
}

Bvh build(const Soup& soup, const Size& size) {
  return bvh::build_grid(soup.positions, soup.triangles, size.columns, size.rows);
}

Bvh build_checked(const Soup& soup, const Size& size) {
  Bvh tree = build(soup, size);
  test::expect_valid(tree, soup, 2);
  return tree;
}

int wrong_hits(const Bvh& tree, const Soup& soup, int rays) {
  test::Tracer tracer(tree, soup);
  std::mt19937 random(21);
  int wrong = 0;
  for (int i = 0; i < rays; ++i) {
    const test::Ray ray = test::random_ray(random);
    double expected = test::kMiss;
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t)
      expected = std::min(expected, test::hit_triangle(soup, t, ray));
    wrong += tracer.closest(ray) == expected ? 0 : 1;
  }
  EXPECT_LE(tracer.deepest, tree.stats.stack_entries);
  return wrong;
}

class BvhGrid : public testing::TestWithParam<Size> {};

TEST_P(BvhGrid, HoldsEveryTriangleOnceAndFindsEveryHit) {
  const Soup soup = grid(GetParam());
  const Bvh tree = build_checked(soup, GetParam());
  EXPECT_EQ(tree.order.size(), soup.triangles.size());
  if (soup.triangles.size() < 3000) {
    EXPECT_EQ(wrong_hits(tree, soup, 2000), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, BvhGrid,
                         testing::Values(Size{1, 1}, Size{1, 2}, Size{2, 1}, Size{3, 3}, Size{1, 9},
                                         Size{7, 8}, Size{8, 8}, Size{9, 8}, Size{8, 9},
                                         Size{1, 200}, Size{33, 17}, Size{37, 31}, Size{100, 100},
                                         Size{64, 256}, Size{255, 257}, Size{1000, 1000}),
                         [](const auto& test) {
                           return std::to_string(test.param.columns) + "x" +
                                  std::to_string(test.param.rows);
                         });

TEST(BvhGridBuild, EmptyGridGivesOneNodeWithoutChildren) {
  for (const Size size : {Size{0, 0}, Size{0, 5}, Size{5, 0}}) {
    const std::vector<vec3> positions((size.columns + 1) * (size.rows + 1), vec3(0.0f));
    const Bvh tree = bvh::build_grid(positions, {}, size.columns, size.rows);
    ASSERT_EQ(tree.nodes.size(), 1u);
    EXPECT_EQ(tree.nodes[0].child[0], AERO_BVH_EMPTY);
    EXPECT_EQ(tree.stats.leaves, 0u);
  }
}

TEST(BvhGridBuild, DropsWhatBuildDrops) {
  const Size size{61, 45};
  Soup soup = grid(size);
  std::mt19937 random(22);
  for (int k = 0; k < 300; ++k) {
    vec3& p = soup.positions[random() % soup.positions.size()];
    if (k % 3 == 0) p.y = std::nanf("");
    if (k % 3 == 1) p = soup.positions[random() % 2 == 0 ? 0 : (&p - soup.positions.data())];
    if (k % 3 == 2) p.x = kInfinity;
  }
  // Cells without an area, a row of them, and blocks in which nothing is left.
  for (std::uint32_t i = 0; i <= 20; ++i) soup.positions[i + 62 * 9] = soup.positions[i + 62 * 8];
  for (std::uint32_t j = 16; j <= 33; ++j) {
    for (std::uint32_t i = 16; i <= 33; ++i) soup.positions[j * 62 + i].y = std::nanf("");
  }
  const Bvh tree = build_checked(soup, size);
  const Bvh general = bvh::build(soup.positions, soup.triangles);
  EXPECT_GT(general.stats.dropped_degenerate, 20u);
  EXPECT_EQ(tree.stats.dropped_degenerate, general.stats.dropped_degenerate);
  EXPECT_EQ(tree.stats.dropped_non_finite, general.stats.dropped_non_finite);
  EXPECT_EQ(tree.bounds.lo, general.bounds.lo);
  EXPECT_EQ(tree.bounds.hi, general.bounds.hi);
}

TEST(BvhGridBuild, NothingButNaNGivesAnEmptyTree) {
  const Size size{20, 20};
  Soup soup = grid(size);
  for (vec3& p : soup.positions) p.y = std::nanf("");
  const Bvh tree = build(soup, size);
  EXPECT_TRUE(tree.order.empty());
  EXPECT_EQ(tree.nodes.size(), 1u);
  EXPECT_EQ(tree.stats.dropped_non_finite, 800u);
}

TEST(BvhGridBuild, KeepsNeedlesThatHaveAnArea) {
  // Corners so near each other, seen from afar, that single precision has no area left.
  const Size size{16, 16};
  Soup soup = grid(size);
  for (vec3& p : soup.positions) p = {1000.0f + 1e-4f * p.x, p.y, p.z * 1e-3f + p.x * 1e-3f};
  const Bvh general = bvh::build(soup.positions, soup.triangles);
  EXPECT_EQ(build_checked(soup, size).order.size(), general.order.size());
}

TEST(BvhGridBuild, GivesTheSameTreeOnAnyNumberOfThreads) {
  const Size size{500, 300};
  const Soup soup = grid(size);
  const Bvh first = build(soup, size);
  for (const std::size_t threads : {1, 7}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_TRUE(test::same_bytes(first, build(soup, size)));
  }
}

TEST(BvhGridBuild, CostsHardlyMoreThanTheGeneralBuild) {
  // Cliffs would like some blocks cut elsewhere.
  for (const auto& [height, limit] : {std::pair(0.01f, 1.05), {0.3f, 1.05}, {3.0f, 1.2}}) {
    const Size size{256, 256};
    const Soup soup = grid(size, height);
    const double own = build_checked(soup, size).stats.sah_cost;
    const double general = bvh::build(soup.positions, soup.triangles).stats.sah_cost;
    EXPECT_LT(own, limit * general) << "heights up to " << height;
  }
}

TEST(BvhGridBuild, StaysWithinTheStackOnGeometricHeights) {
  const Size size{400, 400};
  Soup soup = grid(size);
  for (std::uint32_t k = 0; k < soup.positions.size(); ++k) {
    soup.positions[k].y = std::ldexp(1.0f, static_cast<int>(k % 401 * 250 / 401) - 125);
    soup.positions[k].x = std::ldexp(1.0f, static_cast<int>(k % 401 * 120 / 401));
  }
  EXPECT_LE(build(soup, size).stats.stack_entries, static_cast<std::uint32_t>(bvh::kStackBudget));
}

TEST(BvhGridBuild, RefusesWhatIsNoGrid) {
  const Size size{4, 4};
  Soup soup = grid(size);
  EXPECT_THROW(bvh::build_grid(soup.positions, soup.triangles, 5, 4), Error);
  EXPECT_THROW(bvh::build_grid(soup.positions, soup.triangles, 2, 8), Error);
  EXPECT_THROW(bvh::build_grid(std::span(soup.positions).first(24), soup.triangles, 4, 4), Error);
  bvh::BuildOptions options;
  options.max_leaf_triangles = 1;
  EXPECT_THROW(bvh::build_grid(soup.positions, soup.triangles, 4, 4, options), Error);
  soup.triangles[17].x = 0;
  EXPECT_THROW(build(soup, size), Error);
}

}  // namespace
}  // namespace aerostat
