#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "camera.h"
#include "film_pixel.h"
#include "opencl/launch.hpp"
#include "opencl/program.hpp"
#include "render/geometry.hpp"
#include "render/tiles.hpp"
#include "scene/resolved_scene.hpp"
#include "scene_params.h"

namespace aerostat::bench {

/// Rays in packets of `lanes`. Each packet has eight arrays of `lanes` floats: origin x, y and z,
/// t_max (negative if the ray is not traced), direction x, y and z, and padding.
struct RaySet {
  int lanes = 0;
  std::uint32_t packets = 0;
  std::vector<float> data;

  std::uint64_t active() const;  // number of rays to be traced
};

/// The mean work of a packet with at least one active ray.
struct PacketCounts {
  double nodes = 0.0, leaves = 0.0, triangles = 0.0;
};

/// The renderer's kernels on one device, timed by the clock of the device.
class DeviceBench {
 public:
  /// Uploads the frame and compiles the product's `kernels` together with those of the bench.
  DeviceBench(const opencl::Device& device, int lanes, const scene::ResolvedScene& shown,
              const render::Frame& frame, const opencl::SourceTree& kernels);

  const render::DeviceGeometry& geometry() const { return device_; }
  int lanes() const { return lanes_; }

  /// Returns eye rays through the pixels' centres, in the renderer's packets.
  RaySet camera_rays();
  /// Returns shadow rays to the sun from the hits of the eye rays.
  RaySet shadow_rays();
  /// Returns one ray in a random direction, weighted by the cosine with the surface, from each
  /// hit of the eye rays.
  RaySet bounce_rays();

  /// These functions return the seconds that the renderer's own kernels take for the whole frame.
  double time_camera_kernel();
  double time_shadow_kernel();
  /// Returns the seconds of tracing rays that lie in memory, as other ray tracers get them.
  double time_rays(const RaySet& rays, bool any_hit);
  PacketCounts count(const RaySet& rays, bool any_hit);

 private:
  opencl::LaunchSize size() const;
  const opencl::Buffer<float>& uploaded(const RaySet& rays);

  int lanes_;
  opencl::Context context_;
  opencl::MemoryBudget budget_;
  render::DeviceGeometry device_;
  AeroLaunch launch_{};
  render::SceneBuffer scene_;
  render::FilmBuffer film_;  // none of its pixels is converged
  opencl::Buffer<float> rays_;
  const RaySet* rays_on_device_ = nullptr;
  render::HitBuffer hits_;
  render::VisibleBuffer visible_;
  opencl::Kernel trace_camera_, trace_shadow_, write_camera_, write_shadow_, write_bounce_;
  opencl::Kernel trace_rays_, count_rays_;
};

}  // namespace aerostat::bench
