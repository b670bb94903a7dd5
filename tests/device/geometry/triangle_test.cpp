// Tests hit_triangle against the determinants, written out in double precision.
#include <algorithm>
#include <cmath>
#include <random>

#include "tracing.hpp"

namespace aerostat::test {
namespace {

class Triangles : public LaneTest {
 protected:
  const Probe probe{"trace.cl", GetParam()};

  /// Returns the hit of each ray i on triangle i.
  std::vector<Hit> pairs(const std::vector<AeroTriangle>& triangles,
                         const std::vector<Ray>& rays) const {
    std::vector<AeroTriangle> whole = triangles;
    whole.resize(whole_packets(whole.size()), whole.back());
    const RayBuffers buffers(rays);
    probe.run("probe_pairs", buffers.elements, input(whole), buffers.origins, buffers.directions,
              buffers.t_max, buffers.tuv, buffers.slots);
    return buffers.hits(rays.size());
  }

  /// Returns the hits of all rays on all triangles, which stand in the slots from `first_slot` on.
  std::vector<Hit> all(const std::vector<AeroTriangle>& triangles, const std::vector<Ray>& rays,
                       std::uint32_t first_slot = 0) const {
    const RayBuffers buffers(rays);
    probe.run("probe_triangles", buffers.elements, input(triangles),
              static_cast<std::uint32_t>(triangles.size()), buffers.origins, buffers.directions,
              buffers.t_max, first_slot, buffers.tuv, buffers.slots);
    return buffers.hits(rays.size());
  }
};

AeroTriangle triangle_of(const vec3& a, const vec3& b, const vec3& c) {
  return {{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}};
}

struct Pairs {
  std::vector<AeroTriangle> triangles;
  std::vector<Ray> rays;
};

/// Returns triangles of about `size` around `centre`, seen from up to `distance`. About half of
/// them are hit.
Pairs random_pairs(std::size_t count, float size, float distance, const vec3& centre) {
  std::mt19937 random(41);
  Pairs pairs;
  for (std::size_t i = 0; i < count; ++i) {
    const vec3 a = centre + random_point(random, size), b = centre + random_point(random, size);
    const vec3 c = centre + random_point(random, size);
    const vec3 eye = centre + random_point(random, distance);
    const vec3 target = (a + b + c) / 3.0f + random_point(random, size * 0.5f);
    pairs.triangles.push_back(triangle_of(a, b, c));
    pairs.rays.push_back(ray_towards(eye, dvec3(target)));
  }
  return pairs;
}

double height_of(const AeroTriangle& t, const vec3& direction) {
  // The height is that of the triangle as the ray sees it: its projected area divided by its
  // longest side.
  const dvec3 a(t.v0[0], t.v0[1], t.v0[2]), b(t.v1[0], t.v1[1], t.v1[2]);
  const dvec3 c(t.v2[0], t.v2[1], t.v2[2]);
  const double area = std::abs(glm::dot(glm::cross(b - a, c - a), dvec3(direction)));
  return area / std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
}

void expect_as_exact(const Pairs& pairs, const std::vector<Hit>& hits, double scale) {
  int met = 0, missed = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const Ray& ray = pairs.rays[i];
    const ExactHit exact = exact_hit(pairs.triangles[i], ray);
    // Vertices are known to about 4e-7 of their distance, and a narrow triangle magnifies that.
    const double height = height_of(pairs.triangles[i], ray.direction);
    if (height < 0.01 * scale) continue;
    const double distance = std::abs(exact.t) + 2.0 * scale;
    const double weight_error = 6e-7 * distance / height + 1e-6;
    if (std::abs(exact.slack) < weight_error || std::abs(exact.t) < 1e-5 * distance) continue;
    ASSERT_EQ(hits[i].met(), exact.met(kInfinity)) << i << ": slack " << exact.slack;
    (hits[i].met() ? met : missed)++;
    if (!hits[i].met()) continue;
    ASSERT_NEAR(hits[i].t, exact.t, weight_error * 2.0 * scale + 1e-6 * distance) << i;
    ASSERT_NEAR(hits[i].u, exact.u, weight_error) << i;
    ASSERT_NEAR(hits[i].v, exact.v, weight_error) << i;
  }
  EXPECT_GT(met, static_cast<int>(hits.size()) / 10);
  EXPECT_GT(missed, static_cast<int>(hits.size()) / 10);
}

TEST_P(Triangles, AreMetAsTheDeterminantsSay) {
  const Pairs near = random_pairs(4000, 1.0f, 4.0f, vec3(0.0f));
  expect_as_exact(near, pairs(near.triangles, near.rays), 1.0);
  const Pairs far = random_pairs(4000, 10.0f, 3000.0f, vec3(8000.0f, 700.0f, -15000.0f));
  expect_as_exact(far, pairs(far.triangles, far.rays), 10.0);
  const Pairs small = random_pairs(4000, 0.01f, 1.0f, vec3(0.0f));
  expect_as_exact(small, pairs(small.triangles, small.rays), 0.01);
}

TEST_P(Triangles, AreMetFromBothSides) {
  const AeroTriangle front = triangle_of({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const AeroTriangle back = triangle_of({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  const std::vector<Ray> rays{{{0.25f, 0.125f, 2}, {0, 0, -1}}, {{0.25f, 0.125f, -2}, {0, 0, 1}}};
  for (const AeroTriangle& triangle : {front, back}) {
    for (const Hit& hit : all({triangle}, rays)) {
      ASSERT_TRUE(hit.met());
      EXPECT_FLOAT_EQ(hit.t, 2.0f);
    }
  }
  const Hit hit = all({front}, rays)[0];
  EXPECT_FLOAT_EQ(hit.u, 0.25f);
  EXPECT_FLOAT_EQ(hit.v, 0.125f);
}

TEST_P(Triangles, WithoutAreaAreNotMet) {
  std::mt19937 random(43);
  Pairs flat;
  for (int i = 0; i < 1000; ++i) {
    const vec3 a = random_point(random, 1.0f), b = random_point(random, 1.0f);
    const vec3 corners[][3] = {{a, a, a}, {a, b, b}, {a, b, a}, {a, a, b}};
    const auto& t = corners[i % 4];
    flat.triangles.push_back(triangle_of(t[0], t[1], t[2]));
    flat.rays.push_back(ray_towards(random_point(random, 3.0f), dvec3(t[0] + t[1]) * 0.5));
  }
  for (const Hit& hit : pairs(flat.triangles, flat.rays)) EXPECT_FALSE(hit.met());
}

// Tests triangles that are edge-on, so small that the determinant underflows, or so large that it
// overflows. If there is a hit at all, its distance is finite.
TEST_P(Triangles, OfAnUnusableDeterminantGiveNoHitAtInfinity) {
  const AeroTriangle edge_on = triangle_of({-1, 0, -1}, {1, 0, -1}, {0, 0, -3});
  const Ray ray{{0, 0, 5}, {0, 0, -1}};
  std::vector<AeroTriangle> odd{edge_on};
  for (const float size : {1e-19f, 3e-20f, 1e-20f, 1e-21f, 1e-22f, 1e19f, 1e20f}) {
    odd.push_back(triangle_of({-size, -size, 0}, {size, -size, 0}, {0, size, 0}));
  }
  const std::vector<Hit> hits = pairs(odd, std::vector<Ray>(odd.size(), ray));
  EXPECT_FALSE(hits[0].met());
  for (std::size_t i = 1; i < hits.size(); ++i) {
    EXPECT_TRUE(!hits[i].met() || std::abs(hits[i].t - 5.0f) < 1e-3f)
        << "size " << odd[i].v1[0] << ": t = " << hits[i].t;
  }
}

TEST_P(Triangles, BehindTheOriginOrBeyondTheReachAreNotMet) {
  const AeroTriangle triangle = triangle_of({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  const std::vector<Ray> rays{{{0, 0, 3}, {0, 0, -1}, 3.0f},     {{0, 0, 3}, {0, 0, -1}, 2.9999f},
                              {{0, 0, 3}, {0, 0, 1}, kInfinity}, {{0, 0, 0}, {0, 0, 1}, 1.0f},
                              {{0, 0, 3}, {0, 0, -1}, -1.0f},    {{0, 0, 1e-5f}, {0, 0, 1}, 1.0f}};
  const std::vector<Hit> hits = all({triangle}, rays);
  const bool expected[] = {true, false, false, true, false, false};
  for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_EQ(hits[i].met(), expected[i]) << i;
}

// The eye is within the box of the triangle, which it enters at once.
TEST_P(Triangles, BehindTheOriginInsideTheirBoxAreNotMet) {
  const AeroTriangle slanted = triangle_of({-1, -1, -1}, {1, -1, -1}, {0, 1, 1});
  const vec3 ahead = glm::normalize(vec3(0.1f, 0.05f, 1.0f));
  const std::vector<Ray> rays{{{0, 0, 0.5f}, ahead, kInfinity}, {{0, 0, 0.5f}, -ahead, kInfinity}};
  const std::vector<Hit> hits = all({slanted}, rays);
  EXPECT_FALSE(hits[0].met());
  EXPECT_TRUE(hits[1].met());
}

TEST_P(Triangles, NearestIsKeptInAnyOrder) {
  const auto at = [](float z) { return triangle_of({-1, -1, z}, {1, -1, z}, {0, 1, z}); };
  const std::vector<Ray> rays(3, Ray{{0, 0, 10}, {0, 0, -1}});
  for (const Hit& hit : all({at(1), at(4), at(2), at(-3)}, rays, 20)) {
    EXPECT_EQ(hit.slot, 21u);
    EXPECT_FLOAT_EQ(hit.t, 6.0f);
  }
}

TEST_P(Triangles, AtTheSameDistanceTheLowerSlotWins) {
  const AeroTriangle twin = triangle_of({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  const std::vector<Ray> rays(3, Ray{{0.1f, 0.2f, 10}, {0, 0, -1}});
  for (const Hit& hit : all({twin, twin, twin}, rays, 7)) EXPECT_EQ(hit.slot, 7u);
}

AEROSTAT_AT_EVERY_WIDTH(Triangles);

}  // namespace
}  // namespace aerostat::test
