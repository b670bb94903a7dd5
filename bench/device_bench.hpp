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
#include "scene/scene.hpp"
#include "scene_params.h"

namespace aerostat::bench {

/// Rays in packets of `lanes`: per packet eight arrays of `lanes` floats, namely origin x y z,
/// t_max (negative: not to be traced), direction x y z, and padding.
struct RaySet {
  int lanes = 0;
  std::uint32_t packets = 0;
  std::vector<float> data;

  std::uint64_t active() const;  // rays to be traced
};

/// What an average packet with at least one active ray does.
struct PacketCounts {
  double nodes = 0.0, leaves = 0.0, triangles = 0.0;
};

/// The renderer's kernels on one device, timed by the device's clock.
class DeviceBench {
 public:
  /// `kernels` are the product's.
  DeviceBench(const opencl::Device& device, int lanes, const render::HostGeometry& geometry,
              const opencl::SourceTree& kernels);

  const render::DeviceGeometry& geometry() const { return device_; }
  int lanes() const { return lanes_; }

  /// Eye rays through the pixels' centres, in the renderer's packets.
  RaySet camera_rays();
  /// Shadow rays to the sun from their hits.
  RaySet shadow_rays();
  /// From each of their hits one ray in a random direction, by the cosine with the surface.
  RaySet bounce_rays();

  /// Seconds of the renderer's own kernels over the whole frame.
  double time_camera_kernel();
  double time_shadow_kernel();
  /// Seconds of tracing rays that lie in memory, as the peers get them.
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
  opencl::Buffer<AeroScene> scene_;
  opencl::Buffer<AeroFilmPixel> film_;  // no pixel of it is converged
  opencl::Buffer<float> rays_;
  const RaySet* rays_on_device_ = nullptr;
  opencl::RawBuffer hits_, visible_;
  cl::Kernel trace_camera_, trace_shadow_, write_camera_, write_shadow_, write_bounce_;
  cl::Kernel trace_rays_, count_rays_;
};

}  // namespace aerostat::bench
