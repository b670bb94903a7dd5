#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "camera.h"
#include "opencl/launch.hpp"
#include "opencl/program.hpp"
#include "render/buffers.hpp"
#include "render/integrator.hpp"
#include "render/kernel_progress.hpp"
#include "scene/scene.hpp"

namespace aerostat::render {

/// The number of programs that a render needs.
inline constexpr int kProgramCount = 1;

/// The kernels that make a picture by one integrator, built for one device and one width of
/// packets.
struct Programs {
  opencl::TypedKernel<FilmBuffer, std::uint32_t> clear_film;
  opencl::TypedKernel<FilmBuffer, AeroConvergence> mark_converged;
  opencl::TypedKernel<GuideBuffer, std::uint32_t> clear_guides;
  std::unique_ptr<Integrator> integrator;
  /// The time that building took.
  double seconds = 0.0;
};

/// Builds the kernels up to the machine code for launches of whole work-groups, because some
/// drivers compile only at a launch. Without `guides`, the kernels that add to the guides of a film
/// are left out. The kernel of ambient occlusion comes last. If `ambient_occlusion` is false by
/// then, it is left to its first launch. Throws Error{internal} with the build log.
Programs build_programs(const opencl::Context& context, int lanes, scene::Integrator integrator,
                        bool guides, const std::atomic<bool>& ambient_occlusion,
                        KernelProgress& progress);

/// Builds the kernels for surfaces that let rays pass. They are compiled at their first launches.
std::shared_ptr<const SeeThroughKernels> build_see_through(const opencl::Context& context,
                                                           int lanes);

/// Builds the kernel that finds what mirrors show. It is compiled at its first launch.
std::shared_ptr<const MirrorKernels> build_mirrors(const opencl::Context& context, int lanes);

/// Returns the range of a kernel that works on `packets` packets. It consists of whole work-groups,
/// which are large enough to keep a GPU busy and small enough to spread over the cores of a CPU.
opencl::LaunchSize packet_range(std::uint64_t packets, int lanes);

}  // namespace aerostat::render
