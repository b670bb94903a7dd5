#pragma once

#include <cstdint>

#include "opencl/launch.hpp"
#include "opencl/program.hpp"
#include "render/kernel_progress.hpp"

namespace aerostat::render {

/// The number of programs that `Programs` are made of.
inline constexpr int kProgramCount = 1;

/// The kernels that make a picture, built for one device and one width of packets.
struct Programs {
  opencl::Kernel trace_camera_rays;
  opencl::Kernel trace_shadow_rays;
  opencl::Kernel trace_ambient_rays;
  opencl::Kernel shade_hits;
  opencl::Kernel clear_film;
  opencl::Kernel mark_converged;
  /// The time that building took.
  double seconds = 0.0;
};

/// Builds the kernels up to the machine code for launches of whole work-groups, because some
/// drivers compile only at a launch. Throws Error{internal} with the build log.
Programs build_programs(const opencl::Context& context, int lanes, KernelProgress& progress);

/// Returns the range of a kernel that works on `packets` packets. It consists of whole work-groups,
/// which are large enough to keep a GPU busy and small enough to spread over the cores of a CPU.
opencl::LaunchSize packet_range(std::uint64_t packets, int lanes);

}  // namespace aerostat::render
