#include "render/programs.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "camera.h"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/stopwatch.hpp"
#include "film_pixel.h"
#include "opencl/cache.hpp"
#include "opencl/driver_abort.hpp"

namespace aerostat::render {
namespace {

constexpr std::size_t kGroupLanes = 64;

/// Returns what stands for an argument of type T in a launch without work.
template <typename T>
struct StandIn {
  static T of(const opencl::RawBuffer&) { return T{}; }
};
template <typename T>
struct StandIn<opencl::Buffer<T>> {
  static const opencl::RawBuffer& of(const opencl::RawBuffer& none) { return none; }
};

/// The share of the text, of a film's kernel, and of each kernel of an integrator in the time of a
/// first build, as measured with PoCL.
constexpr double kTextShare = 0.26, kFilmShare = 0.01;

/// Gets the kernels of a program by their names. It also launches each of them once for no packets,
/// because some drivers compile a kernel at its first launch.
class FirstLaunches {
 public:
  FirstLaunches(const opencl::Context& context, const opencl::Program& program, int lanes,
                KernelProgress& progress)
      : context_(context),
        program_(program),
        none_(context, {}, 16, "a first launch", opencl::Access::read_write),
        packets_(packet_range(1, lanes)),
        progress_(progress) {}

  /// Fills in a kernel by its name. `share` is its part of the time of a first build.
  template <typename... Args>
  void take(const char* name, double share, opencl::TypedKernel<Args...>& kernel) const {
    take(name, share, kernel, packets_);
  }
  /// Fills in a kernel without a launch.
  template <typename... Args>
  void take_unlaunched(const char* name, opencl::TypedKernel<Args...>& kernel) const {
    kernel = {program_.kernel(name)};
  }
  template <typename... Args>
  void take_film(const char* name, opencl::TypedKernel<Args...>& kernel) const {
    take(name, kFilmShare, kernel, packet_range(1, 1));
  }

 private:
  template <typename... Args>
  void take(const char* name, double share, opencl::TypedKernel<Args...>& kernel,
            const opencl::LaunchSize& range) const {
    progress_.begin(share);
    kernel = {program_.kernel(name)};
    opencl::launch(context_, kernel.kernel, range, StandIn<Args>::of(none_)...);
    opencl::finish(context_);
  }

  const opencl::Context& context_;
  const opencl::Program& program_;
  opencl::RawBuffer none_;
  opencl::LaunchSize packets_;
  KernelProgress& progress_;
};

/// The share of the kernel that adds to the guides of a film.
constexpr double kGuidesShare = 0.08;

std::unique_ptr<Integrator> local_integrator(const FirstLaunches& first, bool guides,
                                             const std::atomic<bool>& ambient_occlusion) {
  LocalKernels kernels;
  first.take("trace_camera_rays", 0.19, kernels.trace_camera_rays);
  first.take("trace_shadow_rays", 0.20, kernels.trace_shadow_rays);
  first.take("shade_hits", 0.15, kernels.shade_hits);
  if (guides) first.take("note_guides", kGuidesShare, kernels.note_guides);
  if (ambient_occlusion) {
    first.take("trace_ambient_rays", 0.18, kernels.trace_ambient_rays);
  } else {
    first.take_unlaunched("trace_ambient_rays", kernels.trace_ambient_rays);
  }
  return make_integrator(std::move(kernels));
}

std::unique_ptr<Integrator> path_integrator(const FirstLaunches& first, bool guides) {
  PathKernels kernels;
  first.take("start_paths", 0.01, kernels.start_paths);
  first.take("extend_paths", 0.19, kernels.extend_paths);
  first.take("scatter_at_hits", 0.30, kernels.scatter_at_hits);
  first.take("trace_light_rays", 0.19, kernels.trace_light_rays);
  first.take("add_paths", 0.01, kernels.add_paths);
  if (guides) first.take("note_guides", kGuidesShare, kernels.note_guides);
  return make_integrator(std::move(kernels));
}

/// Builds kernels, once more if the driver fails at it: another process may have removed files of
/// PoCL's cache while PoCL read or wrote them. Kernels from a folder are most likely at fault
/// themselves.
template <typename Build>
auto built(const Build& build) {
  const opencl::DriverAbortGuard guard;
  try {
    return build();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::internal || opencl::kernel_folder()) throw;
    const std::string message = error.what();
    warn(fmt::format("{}; the kernels are built once more", message.substr(0, message.find('\n'))));
  }
  opencl::restore_pocl_cache();
  return build();
}

}  // namespace

opencl::LaunchSize packet_range(std::uint64_t packets, int lanes) {
  const std::size_t group = std::max<std::size_t>(1, kGroupLanes / static_cast<std::size_t>(lanes));
  return {(static_cast<std::size_t>(packets) + group - 1) / group * group, group};
}

std::shared_ptr<const SeeThroughKernels> build_see_through(const opencl::Context& context,
                                                           int lanes) {
  return built([&] {
    const opencl::Program program(context, opencl::kernel_sources(), "see_through.cl", lanes);
    auto kernels = std::make_shared<SeeThroughKernels>();
    kernels->pass_eye_rays = {program.kernel("pass_eye_rays")};
    kernels->trace_shadow_rays_on = {program.kernel("trace_shadow_rays_on")};
    kernels->pass_path_rays = {program.kernel("pass_path_rays")};
    kernels->trace_light_rays_on = {program.kernel("trace_light_rays_on")};
    return kernels;
  });
}

std::shared_ptr<const MirrorKernels> build_mirrors(const opencl::Context& context, int lanes) {
  return built([&] {
    const opencl::Program program(context, opencl::kernel_sources(), "mirrors.cl", lanes);
    auto kernels = std::make_shared<MirrorKernels>();
    kernels->look_into_mirrors = {program.kernel("look_into_mirrors")};
    return kernels;
  });
}

Programs build_programs(const opencl::Context& context, int lanes, scene::Integrator integrator,
                        bool guides, const std::atomic<bool>& ambient_occlusion,
                        KernelProgress& progress) {
  const Stopwatch watch;
  const bool local = integrator == scene::Integrator::local;
  Programs programs = built([&] {
    progress.begin(kTextShare);
    const opencl::Program program(context, opencl::kernel_sources(),
                                  local ? "render.cl" : "paths.cl", lanes);
    const FirstLaunches first(context, program, lanes, progress);
    Programs made;
    first.take_film("clear_film", made.clear_film);
    first.take_film("mark_converged", made.mark_converged);
    if (guides) first.take_film("clear_guides", made.clear_guides);
    made.integrator =
        local ? local_integrator(first, guides, ambient_occlusion) : path_integrator(first, guides);
    return made;
  });
  opencl::keep_compiled_kernels();
  progress.finish();
  programs.seconds = watch.seconds();
  return programs;
}

}  // namespace aerostat::render
