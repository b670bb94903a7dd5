#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "bvh/bvh.hpp"
#include "support/bvh_meshes.hpp"
#include "tracer.hpp"
#ifdef AEROSTAT_EMBREE
#include "support/embree_mesh.hpp"
#endif

namespace aerostat {
namespace {

using test::hit_triangle;
using test::kMiss;
using test::random_ray;
using test::Ray;
using test::Soup;
using test::Tracer;

constexpr int kRays = 10000;

struct Case {
  const char* name;
  Soup soup;
  int fewest_hits;
  /// The most tests of a ray as a share of the triangles. It is large for long needles, because
  /// their boxes overlap.
  double most_tests;
};

void PrintTo(const Case& test, std::ostream* out) {
  *out << test.name;
}

class BvhTraversal : public testing::TestWithParam<Case> {};

TEST_P(BvhTraversal, FindsTheSameHitsAsBruteForce) {
  const Soup& soup = GetParam().soup;
  const bvh::Bvh tree = bvh::build(soup.positions, soup.triangles);
  Tracer tracer(tree, soup);
  std::mt19937 random(11);
  int hits = 0, wrong = 0;
  for (int i = 0; i < kRays; ++i) {
    const Ray ray = random_ray(random);
    double expected = kMiss;
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t)
      expected = std::min(expected, hit_triangle(soup, t, ray));
    hits += expected < kMiss ? 1 : 0;
    wrong += tracer.closest(ray) == expected ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(hits, GetParam().fewest_hits);
  EXPECT_LE(tracer.deepest, tree.stats.stack_entries);
  const double all = static_cast<double>(soup.triangles.size()) * kRays;
  EXPECT_LT(static_cast<double>(tracer.triangles_tested), GetParam().most_tests * all);
}

INSTANTIATE_TEST_SUITE_P(Meshes, BvhTraversal,
                         testing::Values(Case{"soup", test::random_soup(1500, 12), 3000, 0.1},
                                         Case{"terrain", test::terrain(28), 4000, 0.05},
                                         Case{"sphere", test::sphere(40), 4000, 0.05},
                                         Case{"slivers", test::slivers(1500, 13), 5, 0.5}),
                         [](const auto& test) { return std::string(test.param.name); });

#ifdef AEROSTAT_EMBREE
TEST(BvhBesideEmbree, AgreesOnALargerTerrain) {
  const Soup soup = test::terrain(256);
  const bvh::Bvh tree = bvh::build(soup.positions, soup.triangles);
  const test::EmbreeMesh peer(soup.positions, soup.triangles);
  Tracer tracer(tree, soup);
  std::mt19937 random(14);
  int wrong = 0;
  for (int i = 0; i < kRays; ++i) {
    const Ray ray = random_ray(random);
    const auto hit = peer.nearest(vec3(ray.origin), vec3(ray.direction));
    const double a = tracer.closest(ray), b = hit.met() ? double{hit.distance} : kMiss;
    if (a != b && !(std::abs(a - b) < 1e-3)) ++wrong;
  }
  // Single precision may decide differently where a ray grazes a silhouette or the border.
  EXPECT_LE(wrong, kRays / 1000);
}
#endif

}  // namespace
}  // namespace aerostat
