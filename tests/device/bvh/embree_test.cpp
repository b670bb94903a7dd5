// Compares the product's traversal with Embree's, ray by ray.
#include <algorithm>

#include "reference_meshes.hpp"
#include "support/embree_mesh.hpp"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kRays = 10000;

/// Returns whether an edge of some triangle is so near to the ray that single precision decides
/// about a hit.
bool grazes(const std::vector<AeroTriangle>& triangles, const Ray& ray) {
  return std::any_of(triangles.begin(), triangles.end(), [&](const AeroTriangle& triangle) {
    const ExactHit hit = exact_hit(triangle, ray);
    const double tolerance = weight_tolerance(triangle, ray, hit.t);
    return hit.t > -1e-3 && (std::abs(hit.slack) < 4.0 * tolerance || std::abs(hit.t) < 1e-3);
  });
}

class BesideEmbree : public testing::TestWithParam<MeshCase> {};

TEST_P(BesideEmbree, TheSameHitsAreFound) {
  const Soup soup = GetParam().soup();
  const TracedMesh mesh(soup);
  const EmbreeMesh peer(soup.positions, soup.triangles);
  const std::vector<Ray> rays = GetParam().rays(kRays, 71);
  const std::vector<Hit> hits = mesh.trace(rays, 16);
  std::size_t different = 0, grazing = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const float expected = peer.nearest(rays[i].origin, rays[i].direction, rays[i].t_max).distance;
    const bool both_miss = !hits[i].met() && expected == kInfinity;
    if (both_miss || std::abs(hits[i].t - expected) <= 1e-4f * expected + 1e-6f) continue;
    (grazes(mesh.triangles(), rays[i]) ? grazing : different)++;
  }
  EXPECT_EQ(different, 0u);
  EXPECT_LE(grazing, kRays / 200);
}

INSTANTIATE_TEST_SUITE_P(Meshes, BesideEmbree, testing::ValuesIn(reference_meshes()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace aerostat::test
