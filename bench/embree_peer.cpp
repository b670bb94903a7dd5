#include "embree_peer.hpp"

#include <algorithm>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include "core/stopwatch.hpp"
#include "embree_api.hpp"

namespace aerostat::bench {

struct EmbreePeer::State {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);

  ~State() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

namespace {

constexpr std::size_t kWidth = 16;
constexpr std::uint32_t kGrain = 64;  // number of packets of a task

void attach(RTCDevice device, RTCScene scene, const mesh::TriangleMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3), mesh.positions.size()));
  auto* triangles = static_cast<uvec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3), mesh.triangles.size()));
  std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
  std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

/// Runs f(first float of a packet) for all packets on all cores. Returns the seconds.
template <typename F>
double over_packets(const RaySet& rays, F f) {
  const Stopwatch watch;
  const auto stride = static_cast<std::size_t>(rays.lanes) * 8;
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, rays.packets, kGrain),
                    [&](const tbb::blocked_range<std::uint32_t>& range) {
                      for (std::uint32_t i = range.begin(); i < range.end(); ++i) {
                        f(rays.data.data() + i * stride);
                      }
                    });
  return watch.seconds();
}

embree::Query query_for(Coherence coherence) {
  return embree::Query(coherence == Coherence::coherent);
}

template <typename Ray>
void set_ray(Ray& ray, const float* packet, std::size_t lanes, std::size_t i) {
  ray.org_x = packet[i];
  ray.org_y = packet[lanes + i];
  ray.org_z = packet[2 * lanes + i];
  ray.tfar = packet[3 * lanes + i];
  ray.dir_x = packet[4 * lanes + i];
  ray.dir_y = packet[5 * lanes + i];
  ray.dir_z = packet[6 * lanes + i];
  ray.tnear = 0.0f;
  ray.time = 0.0f;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
}

/// Sets sixteen rays and the flags that tell which of them are active.
void set_rays(RTCRay16& rays, int* valid, const float* packet) {
  std::copy_n(packet, kWidth, rays.org_x);
  std::copy_n(packet + kWidth, kWidth, rays.org_y);
  std::copy_n(packet + 2 * kWidth, kWidth, rays.org_z);
  std::copy_n(packet + 3 * kWidth, kWidth, rays.tfar);
  std::copy_n(packet + 4 * kWidth, kWidth, rays.dir_x);
  std::copy_n(packet + 5 * kWidth, kWidth, rays.dir_y);
  std::copy_n(packet + 6 * kWidth, kWidth, rays.dir_z);
  for (std::size_t i = 0; i < kWidth; ++i) {
    rays.tnear[i] = 0.0f;
    rays.time[i] = 0.0f;
    rays.mask[i] = ~0u;
    rays.id[i] = rays.flags[i] = 0;
    valid[i] = rays.tfar[i] >= 0.0f ? -1 : 0;
  }
}

}  // namespace

EmbreePeer::EmbreePeer(const render::HostGeometry& geometry) : state_(std::make_unique<State>()) {
  for (const auto& object : world::as_triangles(geometry.world))
    attach(state_->device, state_->scene, object.mesh);
  const Stopwatch watch;
  rtcCommitScene(state_->scene);
  commit_seconds_ = watch.seconds();
}

EmbreePeer::~EmbreePeer() = default;

double EmbreePeer::time_commit(const mesh::TriangleMesh& mesh) const {
  RTCScene scene = rtcNewScene(state_->device);
  attach(state_->device, scene, mesh);
  const Stopwatch watch;
  rtcCommitScene(scene);
  const double seconds = watch.seconds();
  rtcReleaseScene(scene);
  return seconds;
}

double EmbreePeer::time_closest_1(const RaySet& rays) const {
  return over_packets(rays, [&](const float* packet) {
    auto query = query_for(Coherence::incoherent);
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.lanes); ++i) {
      RTCRayHit hit;
      set_ray(hit.ray, packet, static_cast<std::size_t>(rays.lanes), i);
      hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      if (hit.ray.tfar >= 0.0f) query.closest_1(state_->scene, hit);
    }
  });
}

double EmbreePeer::time_occluded_1(const RaySet& rays) const {
  return over_packets(rays, [&](const float* packet) {
    auto query = query_for(Coherence::incoherent);
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.lanes); ++i) {
      RTCRay ray;
      set_ray(ray, packet, static_cast<std::size_t>(rays.lanes), i);
      if (ray.tfar >= 0.0f) query.occluded_1(state_->scene, ray);
    }
  });
}

double EmbreePeer::time_closest_16(const RaySet& rays, Coherence coherence) const {
  return over_packets(rays, [&](const float* packet) {
    alignas(64) int valid[kWidth];
    alignas(64) RTCRayHit16 hits;
    set_rays(hits.ray, valid, packet);
    std::fill_n(hits.hit.geomID, kWidth, RTC_INVALID_GEOMETRY_ID);
    auto query = query_for(coherence);
    query.closest_16(valid, state_->scene, hits);
  });
}

double EmbreePeer::time_occluded_16(const RaySet& rays, Coherence coherence) const {
  return over_packets(rays, [&](const float* packet) {
    alignas(64) int valid[kWidth];
    alignas(64) RTCRay16 ray;
    set_rays(ray, valid, packet);
    auto query = query_for(coherence);
    query.occluded_16(valid, state_->scene, ray);
  });
}

}  // namespace aerostat::bench
