#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/math.hpp"
#include "embree_api.hpp"

namespace aerostat::test {

/// Finds the nearest hits on a mesh with Embree in its robust mode, in which no ray slips through
/// an edge.
class EmbreeMesh {
 public:
  EmbreeMesh(const std::vector<vec3>& positions, const std::vector<uvec3>& triangles)
      : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<vec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3), positions.size()));
    auto* indices = static_cast<uvec3*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3), triangles.size()));
    std::copy(positions.begin(), positions.end(), corners);
    std::copy(triangles.begin(), triangles.end(), indices);
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

  struct Hit {
    float distance = std::numeric_limits<float>::infinity();
    std::uint32_t triangle = 0;

    bool met() const { return distance != std::numeric_limits<float>::infinity(); }
  };

  /// Returns the nearest hit up to the distance `t_max`.
  Hit nearest(const vec3& origin, const vec3& direction,
              float t_max = std::numeric_limits<float>::infinity()) const {
    RTCRayHit query{};
    query.ray.org_x = origin.x;
    query.ray.org_y = origin.y;
    query.ray.org_z = origin.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    query.ray.tfar = t_max;
    query.ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree::Query().closest_1(scene_, query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {query.ray.tfar, query.hit.primID};
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace aerostat::test
