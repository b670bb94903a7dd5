#include "render/programs.hpp"

#include <algorithm>

#include "camera.h"
#include "core/stopwatch.hpp"
#include "film_pixel.h"
#include "opencl/cache.hpp"
#include "opencl/driver_abort.hpp"

namespace aerostat::render {
namespace {

constexpr std::size_t kGroupLanes = 64;

/// The share of each step in the time of a first build, as measured with PoCL.
struct Shares {
  double text = 0.26, camera = 0.19, shadow = 0.20, ambient = 0.18, shade = 0.15, film = 0.01;
};

/// Returns what stands for an argument of type T in a launch without work.
template <typename T>
struct StandIn {
  static T of(const opencl::RawBuffer&) { return T{}; }
};
template <typename T>
struct StandIn<opencl::Buffer<T>> {
  static const opencl::RawBuffer& of(const opencl::RawBuffer& none) { return none; }
};

/// Launches every kernel once without work.
void warm_up(const opencl::Context& context, const Programs& programs, int lanes,
             KernelProgress& progress) {
  const opencl::MemoryBudget budget;
  const opencl::RawBuffer none(context, budget, 16, "a first launch", opencl::Access::read_write);
  const auto step = [&]<typename... Args>(double share, const opencl::TypedKernel<Args...>& typed,
                                          const opencl::LaunchSize& range) {
    progress.begin(share);
    opencl::launch(context, typed.kernel, range, StandIn<Args>::of(none)...);
    opencl::finish(context);
  };
  const Shares share;
  const auto packets = packet_range(1, lanes), pixels = packet_range(1, 1);
  step(share.camera, programs.trace_camera_rays, packets);
  step(share.shadow, programs.trace_shadow_rays, packets);
  step(share.ambient, programs.trace_ambient_rays, packets);
  step(share.shade, programs.shade_hits, packets);
  step(share.film, programs.clear_film, pixels);
  step(share.film, programs.mark_converged, pixels);
}

}  // namespace

opencl::LaunchSize packet_range(std::uint64_t packets, int lanes) {
  const std::size_t group = std::max<std::size_t>(1, kGroupLanes / static_cast<std::size_t>(lanes));
  return {(static_cast<std::size_t>(packets) + group - 1) / group * group, group};
}

Programs build_programs(const opencl::Context& context, int lanes, KernelProgress& progress) {
  const Stopwatch watch;
  const opencl::DriverAbortGuard guard;
  progress.begin(Shares{}.text);
  const opencl::Program rendering(context, opencl::kernel_sources(), "render.cl", lanes);
  Programs programs;
  programs.trace_camera_rays = {rendering.kernel("trace_camera_rays")};
  programs.trace_shadow_rays = {rendering.kernel("trace_shadow_rays")};
  programs.trace_ambient_rays = {rendering.kernel("trace_ambient_rays")};
  programs.shade_hits = {rendering.kernel("shade_hits")};
  programs.clear_film = {rendering.kernel("clear_film")};
  programs.mark_converged = {rendering.kernel("mark_converged")};
  warm_up(context, programs, lanes, progress);
  opencl::keep_compiled_kernels();
  progress.finish();
  programs.seconds = watch.seconds();
  return programs;
}

}  // namespace aerostat::render
