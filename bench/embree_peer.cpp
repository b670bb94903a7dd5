#include "embree_peer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <variant>
#include <vector>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include "core/stopwatch.hpp"
#include "embree_api.hpp"

namespace aerostat::bench {

namespace {

constexpr std::uint32_t kGrain = 64;  // number of packets of a task

/// Attaches a geometry to a scene, which keeps it.
void attach(RTCScene scene, RTCGeometry geometry) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

void attach_mesh(RTCDevice device, RTCScene scene, const mesh::TriangleMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3), mesh.positions.size()));
  auto* triangles = static_cast<uvec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3), mesh.triangles.size()));
  std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
  std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
  attach(scene, geometry);
}

/// Attaches a model at the place of an instance.
void attach_instance(RTCDevice device, RTCScene scene, RTCScene model,
                     const scatter::Instance& instance) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, model);
  const scatter::Axes axes = scatter::axes_of(instance);
  const std::array columns{axes.x, axes.y, axes.z, instance.position};
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
  attach(scene, geometry);
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

/// Sets the rays of a packet and the flags that tell which of them are active.
template <std::size_t kWidth, typename Rays>
void set_rays(Rays& rays, int* valid, const float* packet) {
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

template <std::size_t kWidth, typename Hits>
double time_closest(const RaySet& rays, Coherence coherence, RTCScene scene) {
  return over_packets(rays, [&](const float* packet) {
    alignas(64) int valid[kWidth];
    alignas(64) Hits hits;
    set_rays<kWidth>(hits.ray, valid, packet);
    std::fill_n(hits.hit.geomID, kWidth, RTC_INVALID_GEOMETRY_ID);
    auto query = query_for(coherence);
    query.closest(valid, scene, hits);
  });
}

template <std::size_t kWidth, typename Rays>
double time_occluded(const RaySet& rays, Coherence coherence, RTCScene scene) {
  return over_packets(rays, [&](const float* packet) {
    alignas(64) int valid[kWidth];
    alignas(64) Rays occluded;
    set_rays<kWidth>(occluded, valid, packet);
    auto query = query_for(coherence);
    query.occluded(valid, scene, occluded);
  });
}

}  // namespace

struct EmbreePeer::State {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);

  ~State() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  /// Builds a tree for each model and attaches it wherever a plant stands.
  void attach_plants(const world::Instances& plants) {
    std::vector<RTCScene> models;
    for (const world::InstanceModel& model : plants.models) {
      models.push_back(rtcNewScene(device));
      for (const world::Object& part : *model.parts) attach_mesh(device, models.back(), part.mesh);
      rtcCommitScene(models.back());
    }
    for (const scatter::Instance& place : plants.places)
      attach_instance(device, scene, models[place.model], place);
    for (RTCScene model : models) rtcReleaseScene(model);  // the instances keep them
  }
};

EmbreePeer::EmbreePeer(const render::HostGeometry& geometry) : state_(std::make_unique<State>()) {
  for (const auto& object : world::as_triangles(geometry.world))
    attach_mesh(state_->device, state_->scene, object.mesh);
  const Stopwatch watch;
  for (const world::Group& group : geometry.world.groups) {
    const auto* plants = group.shape ? std::get_if<world::Instances>(group.shape.get()) : nullptr;
    if (plants != nullptr && plants->are_plants) state_->attach_plants(*plants);
  }
  rtcCommitScene(state_->scene);
  commit_seconds_ = watch.seconds();
}

EmbreePeer::~EmbreePeer() = default;

double EmbreePeer::time_commit(const mesh::TriangleMesh& mesh) const {
  RTCScene scene = rtcNewScene(state_->device);
  attach_mesh(state_->device, scene, mesh);
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

double EmbreePeer::time_closest_packets(const RaySet& rays, Coherence coherence) const {
  switch (rays.lanes) {
    case 4:
      return time_closest<4, RTCRayHit4>(rays, coherence, state_->scene);
    case 8:
      return time_closest<8, RTCRayHit8>(rays, coherence, state_->scene);
    default:
      return time_closest<16, RTCRayHit16>(rays, coherence, state_->scene);
  }
}

double EmbreePeer::time_occluded_packets(const RaySet& rays, Coherence coherence) const {
  switch (rays.lanes) {
    case 4:
      return time_occluded<4, RTCRay4>(rays, coherence, state_->scene);
    case 8:
      return time_occluded<8, RTCRay8>(rays, coherence, state_->scene);
    default:
      return time_occluded<16, RTCRay16>(rays, coherence, state_->scene);
  }
}

}  // namespace aerostat::bench
