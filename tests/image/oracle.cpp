#include "oracle.hpp"

#include <algorithm>

#ifdef AEROSTAT_TEST_EMBREE
#include <embree3/rtcore.h>
#endif

namespace aerostat::test {

#ifdef AEROSTAT_TEST_EMBREE

struct Oracle::State {
  explicit State(const ExportedWorld& given)
      : world(given), device(rtcNewDevice(nullptr)), scene(rtcNewScene(device)) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX,
                                                                 0, RTC_FORMAT_FLOAT3, sizeof(vec3),
                                                                 world.positions.size()));
    auto* triangles = static_cast<uvec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3),
                                world.triangles.size()));
    std::copy(world.positions.begin(), world.positions.end(), positions);
    std::copy(world.triangles.begin(), world.triangles.end(), triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  const ExportedWorld& world;
  RTCDevice device;
  RTCScene scene;
};

Oracle::Answer Oracle::nearest(const dvec3& origin, const dvec3& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(origin.x);
  query.ray.org_y = static_cast<float>(origin.y);
  query.ray.org_z = static_cast<float>(origin.z);
  query.ray.dir_x = static_cast<float>(direction.x);
  query.ray.dir_y = static_cast<float>(direction.y);
  query.ray.dir_z = static_cast<float>(direction.z);
  query.ray.tfar = kInfinity;
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(state_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {query.ray.tfar, state_->world.objects[query.hit.primID]};
}

int Oracle::stride() {
  return 1;
}

#else

struct Oracle::State {
  explicit State(const ExportedWorld& given) : world(given) {}
  const ExportedWorld& world;
};

Oracle::Answer Oracle::nearest(const dvec3& origin, const dvec3& direction) const {
  const ExportedWorld& world = state_->world;
  Answer answer;
  for (std::size_t i = 0; i < world.triangles.size(); ++i) {
    const uvec3& t = world.triangles[i];
    const dvec3 v0(world.positions[t.x]);
    const dvec3 e1 = dvec3(world.positions[t.y]) - v0, e2 = dvec3(world.positions[t.z]) - v0;
    const dvec3 p = glm::cross(direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant == 0.0) continue;
    const dvec3 s = origin - v0;
    const double u = glm::dot(s, p) / determinant;
    if (u < 0.0 || u > 1.0) continue;
    const dvec3 q = glm::cross(s, e1);
    const double v = glm::dot(direction, q) / determinant;
    const double distance = glm::dot(e2, q) / determinant;
    if (v < 0.0 || u + v > 1.0 || distance <= 0.0 || distance >= answer.distance) continue;
    answer = {distance, world.objects[i]};
  }
  return answer;
}

int Oracle::stride() {
  return 16;
}

#endif

Oracle::Oracle(const ExportedWorld& world) : state_(std::make_unique<State>(world)) {}

Oracle::~Oracle() = default;

}  // namespace aerostat::test
