#include "render/programs.hpp"

#include <algorithm>
#include <future>

#include "camera.h"
#include "core/stopwatch.hpp"

namespace aerostat::render {
namespace {

constexpr std::size_t kGroupLanes = 64;

/// Launches every kernel on nothing.
void warm_up(const opencl::Context& context, Programs& programs, int lanes) {
  const opencl::MemoryBudget budget;
  const opencl::RawBuffer nothing(context, budget, 16, "a first launch", CL_MEM_READ_WRITE);
  const cl::Buffer& none = nothing.handle();
  const AeroLaunch launch{};
  const auto range = packet_range(1, lanes);
  opencl::launch(context, programs.trace_camera_rays, range, launch, none, none, none, none, none);
  opencl::launch(context, programs.trace_shadow_rays, range, launch, none, none, none, none, none,
                 none, none, none, none);
  opencl::launch(context, programs.trace_ambient_rays, range, launch, none, none, none, none, none,
                 none, none, none, none);
  opencl::launch(context, programs.shade_hits, range, launch, none, none, none, none, none, none,
                 none, none, none);
  opencl::launch(context, programs.clear_film, packet_range(1, 1), none, cl_uint{0});
  opencl::finish(context);
}

}  // namespace

opencl::LaunchSize packet_range(std::uint64_t packets, int lanes) {
  const std::size_t group = std::max<std::size_t>(1, kGroupLanes / static_cast<std::size_t>(lanes));
  return {(static_cast<std::size_t>(packets) + group - 1) / group * group, group};
}

Programs build_programs(const opencl::Context& context, int lanes) {
  const Stopwatch watch;
  const opencl::SourceTree sources = opencl::kernel_sources();
  const auto build = [&](const char* entry) {
    return std::async(std::launch::async, [&context, &sources, lanes, entry] {
      return opencl::Program(context, sources, entry, lanes);
    });
  };
  auto camera = build("trace_camera.cl");
  auto shadow = build("trace_shadow.cl");
  auto ambient = build("trace_ambient.cl");
  auto shade = build("shade_hits.cl");
  Programs programs;
  programs.trace_camera_rays = camera.get().kernel("trace_camera_rays");
  programs.trace_shadow_rays = shadow.get().kernel("trace_shadow_rays");
  programs.trace_ambient_rays = ambient.get().kernel("trace_ambient_rays");
  const opencl::Program shading = shade.get();
  programs.shade_hits = shading.kernel("shade_hits");
  programs.clear_film = shading.kernel("clear_film");
  warm_up(context, programs, lanes);
  programs.seconds = watch.seconds();
  return programs;
}

}  // namespace aerostat::render
