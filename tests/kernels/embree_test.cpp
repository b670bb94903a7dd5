// The product's traversal beside Embree's, ray by ray.
#include <embree3/rtcore.h>

#include "reference_meshes.hpp"
#include "tracing.hpp"

namespace aerostat::test {
namespace {

constexpr std::size_t kRays = 10000;

/// Embree's nearest hits on a soup.
class EmbreeMesh {
 public:
  explicit EmbreeMesh(const Soup& soup)
      : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX,
                                                                 0, RTC_FORMAT_FLOAT3, sizeof(vec3),
                                                                 soup.positions.size()));
    auto* triangles = static_cast<uvec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3),
                                soup.triangles.size()));
    std::copy(soup.positions.begin(), soup.positions.end(), positions);
    std::copy(soup.triangles.begin(), soup.triangles.end(), triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene_);
  }
  EmbreeMesh(const EmbreeMesh&) = delete;
  EmbreeMesh& operator=(const EmbreeMesh&) = delete;
  ~EmbreeMesh() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  /// +inf for none.
  float distance(const Ray& ray) const {
    RTCIntersectContext state;
    rtcInitIntersectContext(&state);
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x;
    query.ray.org_y = ray.origin.y;
    query.ray.org_z = ray.origin.z;
    query.ray.dir_x = ray.direction.x;
    query.ray.dir_y = ray.direction.y;
    query.ray.dir_z = ray.direction.z;
    query.ray.tfar = ray.t_max;
    query.ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &state, &query);
    return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kInfinity : query.ray.tfar;
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

/// Whether some triangle's edge is so near to the ray that single precision decides.
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
  const EmbreeMesh peer(soup);
  const std::vector<Ray> rays = GetParam().rays(kRays, 71);
  const std::vector<Hit> hits = mesh.trace(rays, 16);
  std::size_t different = 0, grazing = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const float expected = peer.distance(rays[i]);
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
