#pragma once

#include <cstdint>

#include "opencl/launch.hpp"
#include "opencl/program.hpp"
#include "render/kernel_progress.hpp"

namespace aerostat::render {

/// Of how many programs `Programs` are made.
inline constexpr int kProgramCount = 1;

/// The kernels that make a picture, built for one device and lane width.
struct Programs {
  cl::Kernel trace_camera_rays;
  cl::Kernel trace_shadow_rays;
  cl::Kernel trace_ambient_rays;
  cl::Kernel shade_hits;
  cl::Kernel clear_film;
  cl::Kernel mark_converged;
  double seconds = 0.0;  // that building took
};

/// Builds them, up to the machine code that launches of whole groups need: some
/// drivers compile only then. Throws Error{internal} with the build log.
Programs build_programs(const opencl::Context& context, int lanes, KernelProgress& progress);

/// The range of a kernel that works on `packets` packets: whole work-groups, large enough to keep a
/// GPU busy and small enough to spread over CPU cores.
opencl::LaunchSize packet_range(std::uint64_t packets, int lanes);

}  // namespace aerostat::render
