#include "render/programs.hpp"

#include <future>

#include "core/stopwatch.hpp"

namespace aerostat::render {

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
  auto shade = build("shade_hits.cl");
  Programs programs;
  programs.trace_camera_rays = camera.get().kernel("trace_camera_rays");
  programs.trace_shadow_rays = shadow.get().kernel("trace_shadow_rays");
  const opencl::Program shading = shade.get();
  programs.shade_hits = shading.kernel("shade_hits");
  programs.clear_film = shading.kernel("clear_film");
  programs.seconds = watch.seconds();
  return programs;
}

}  // namespace aerostat::render
