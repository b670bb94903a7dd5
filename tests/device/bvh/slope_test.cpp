// Tests ground that is skipped as a whole because it faces away from rays, against brute force.
#include <cmath>
#include <functional>
#include <ostream>
#include <random>

#include "bvh_node.h"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

/// The number of cells on a side. It gives patches of both shapes, and some that are not whole.
constexpr std::uint32_t kCells = 37;
constexpr std::size_t kBundle = 64;
constexpr std::size_t kBundles = 96;
// A slope slightly less than one that nodes hold exactly. It is rounded to that one in the nodes.
constexpr float kSlope = 0.5f - 0.02f / AERO_SLOPE_STEPS;

float uniform(std::mt19937& random, float lo, float hi) {
  return std::uniform_real_distribution<float>(lo, hi)(random);
}

/// A kind of ground, given by its heights over cells one metre wide.
struct Ground {
  const char* name;
  std::function<float(std::mt19937&, std::uint32_t i, std::uint32_t j)> height;
};

void PrintTo(const Ground& ground, std::ostream* out) {
  *out << ground.name;
}

std::vector<Ground> grounds() {
  return {
      {"random heights", [](std::mt19937& random, auto, auto) { return uniform(random, 0, 1.5f); }},
      {"spikes on a plain",
       [](std::mt19937& random, auto, auto) {
         return random() % 40 == 0 ? uniform(random, 1.0f, 12.0f) : 0.0f;
       }},
      {"terraces with steep walls",
       [](std::mt19937&, auto i, auto j) { return 4.0f * static_cast<float>(i / 9 + j / 13); }},
      {"a slope up x, smooth", [](auto&, auto i, auto) { return kSlope * static_cast<float>(i); }},
      {"a slope up x, hardly rough",
       [](std::mt19937& random, auto i, auto) {
         return kSlope * static_cast<float>(i) + uniform(random, 0.0f, 0.01f);
       }},
      {"a slope down both, smooth",
       [](std::mt19937&, auto i, auto j) { return -0.25f * static_cast<float>(i + j); }},
      {"ridges across x, as steep as bytes can say and steeper",
       [](std::mt19937& random, auto i, auto) {
         return i % 3 == 1 ? uniform(random, 6.0f, 9.0f) : 0.0f;
       }},
  };
}

mesh::GridMesh grid_of(const Ground& ground) {
  std::vector<float> lines;
  for (std::uint32_t k = 0; k <= kCells; ++k) lines.push_back(static_cast<float>(k));
  mesh::GridMesh grid(lines, lines);
  std::mt19937 random(81);
  for (std::uint32_t j = 0; j <= kCells; ++j) {
    for (std::uint32_t i = 0; i <= kCells; ++i)
      grid.set(i, j, ground.height(random, i, j), vec3(0.0f, 1.0f, 0.0f));
  }
  return grid;
}

/// Returns a point a little above the ground.
vec3 above(const mesh::GridMesh& grid, std::mt19937& random) {
  const auto i = static_cast<std::uint32_t>(random() % kCells);
  const auto j = static_cast<std::uint32_t>(random() % kCells);
  const float lift = std::pow(10.0f, uniform(random, -3.0f, 0.5f));
  return 0.5f * (grid.position(i, j) + grid.position(i + 1, j + 1)) +
         vec3(0.0f, lift + 0.5f * std::fabs(grid.height(i + 1, j) - grid.height(i, j + 1)), 0.0f);
}

/// Returns the common direction of a bundle's rays. They rise or fall with the ground, nearly level
/// with it, along its rows, across them, or in any direction.
vec3 common_direction(std::mt19937& random, std::size_t bundle) {
  const float graze = std::pow(10.0f, uniform(random, -3.0f, -1.0f));
  const float side = random() % 2 == 0 ? 1.0f : -1.0f;
  switch (bundle % 6) {
    case 0:
      return {side, kSlope * side - graze, uniform(random, -0.001f, 0.001f)};
    case 1:
      return {uniform(random, -1.0f, 1.0f), -graze, side};
    case 2:
      return {side, 0.0f, uniform(random, -0.2f, 0.2f)};
    case 3:
      return {2e-5f * side, graze, 1.0f};
    case 4:
      return {side, -0.25f * side - graze, 1e-4f};
    default:
      return random_direction(random);
  }
}

/// Returns bundles like those towards the sun, with and without the spread of its disc, from just
/// above the ground and from higher up.
std::vector<Ray> rays_over(const mesh::GridMesh& grid) {
  std::mt19937 random(82);
  std::vector<Ray> rays;
  for (std::size_t b = 0; b < kBundles; ++b) {
    const vec3 common = common_direction(random, b);
    const float spread = b / 6 % 2 == 0 ? 0.0f : 0.02f;
    for (std::size_t k = 0; k < kBundle; ++k) {
      const vec3 direction = glm::normalize(common + spread * random_point(random, 1.0f));
      const vec3 start = above(grid, random);
      rays.push_back({b / 12 % 4 == 3 ? start + vec3(0.0f, 8.0f, 0.0f) : start, direction});
      if (k % 13 == 0) rays.back().t_max = uniform(random, -1.0f, 5.0f);
    }
  }
  return rays;
}

class Slopes : public testing::TestWithParam<Ground> {};

TEST_P(Slopes, LoseNothingThatARayEnters) {
  const mesh::GridMesh grid = grid_of(GetParam());
  const mesh::TriangleMesh triangles = mesh::to_triangles(grid);
  const std::vector<Ray> rays = rays_over(grid);
  std::vector<int> expected;
  std::size_t sure = 0, entering = 0;
  for (const Ray& ray : rays) {
    expected.push_back(ray.t_max < 0.0f ? 0 : enters(triangles, ray));
    sure += expected.back() >= 0 ? 1 : 0;
    entering += expected.back() == 1 ? 1 : 0;
  }
  EXPECT_GT(sure, rays.size() * 3 / 4);
  EXPECT_GT(entering, rays.size() / 10);
  EXPECT_LT(entering, rays.size() * 9 / 10);
  const TracedMesh traced(grid);
  for (const int lanes : {1, 4, 8, 16}) {
    const auto hits = traced.trace_bundles(rays, lanes, Wanted::any_from_above);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (expected[i] < 0) continue;
      ASSERT_EQ(hits[i].met(), expected[i] == 1) << "ray " << i << ", " << lanes << " lanes";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Grounds, Slopes, testing::ValuesIn(grounds()));

}  // namespace
}  // namespace aerostat::test
