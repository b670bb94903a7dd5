#include "render/programs.hpp"

#include <algorithm>
#include <future>

#include "camera.h"
#include "core/stopwatch.hpp"
#include "film_pixel.h"

namespace aerostat::render {
namespace {

constexpr std::size_t kGroupLanes = 64;

/// The kernels that walk the trees, as one program: they share nearly all of their code, and what a
/// driver does to find a program among those it has compiled is done once for all three.
constexpr const char* kTracing = "trace.cl";
constexpr const char* kTracingText =
    "#include \"trace_camera.cl\"\n"
    "#include \"trace_shadow.cl\"\n"
    "#include \"trace_ambient.cl\"\n";

/// Launches every kernel on nothing.
void warm_up(const opencl::Context& context, Programs& programs, int lanes) {
  const opencl::MemoryBudget budget;
  const opencl::RawBuffer nothing(context, budget, 16, "a first launch", CL_MEM_READ_WRITE);
  const cl::Buffer& none = nothing.handle();
  const AeroLaunch launch{};
  const auto range = packet_range(1, lanes);
  opencl::launch(context, programs.trace_camera_rays, range, launch, none, none, none, none, none,
                 none);
  opencl::launch(context, programs.trace_shadow_rays, range, launch, none, none, none, none, none,
                 none, none, none, none);
  opencl::launch(context, programs.trace_ambient_rays, range, launch, none, none, none, none, none,
                 none, none, none, none);
  opencl::launch(context, programs.shade_hits, range, launch, none, none, none, none, none, none,
                 none, none, none);
  opencl::launch(context, programs.clear_film, packet_range(1, 1), none, cl_uint{0});
  opencl::launch(context, programs.settle_film, packet_range(1, 1), none, AeroSettling{});
  opencl::finish(context);
}

}  // namespace

opencl::LaunchSize packet_range(std::uint64_t packets, int lanes) {
  const std::size_t group = std::max<std::size_t>(1, kGroupLanes / static_cast<std::size_t>(lanes));
  return {(static_cast<std::size_t>(packets) + group - 1) / group * group, group};
}

Programs build_programs(const opencl::Context& context, int lanes) {
  const Stopwatch watch;
  opencl::SourceTree sources = opencl::kernel_sources();
  sources.emplace(kTracing, kTracingText);
  const auto build = [&](const char* entry) {
    return std::async(std::launch::async, [&context, &sources, lanes, entry] {
      return opencl::Program(context, sources, entry, lanes);
    });
  };
  auto trace = build(kTracing);
  auto shade = build("shade_hits.cl");
  Programs programs;
  const opencl::Program tracing = trace.get();
  programs.trace_camera_rays = tracing.kernel("trace_camera_rays");
  programs.trace_shadow_rays = tracing.kernel("trace_shadow_rays");
  programs.trace_ambient_rays = tracing.kernel("trace_ambient_rays");
  const opencl::Program shading = shade.get();
  programs.shade_hits = shading.kernel("shade_hits");
  programs.clear_film = shading.kernel("clear_film");
  programs.settle_film = shading.kernel("settle_film");
  warm_up(context, programs, lanes);
  programs.seconds = watch.seconds();
  return programs;
}

}  // namespace aerostat::render
