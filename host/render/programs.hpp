#pragma once

#include <cstdint>

#include "camera.h"
#include "opencl/launch.hpp"
#include "opencl/program.hpp"
#include "render/buffers.hpp"
#include "render/kernel_progress.hpp"

namespace aerostat::render {

/// The number of programs that `Programs` are made of.
inline constexpr int kProgramCount = 1;

/// The kernels that make a picture, built for one device and one width of packets.
struct Programs {
  opencl::TypedKernel<AeroLaunch, NodeBuffer, TriangleBuffer, InstanceBuffer, GridBuffer,
                      FilmBuffer, HitBuffer>
      trace_camera_rays;
  opencl::TypedKernel<AeroLaunch, SceneBuffer, NodeBuffer, TriangleBuffer, InstanceBuffer,
                      GridBuffer, FaceBuffer, VertexBuffer, HitBuffer, VisibleBuffer>
      trace_shadow_rays;
  opencl::TypedKernel<AeroLaunch, SceneBuffer, NodeBuffer, TriangleBuffer, InstanceBuffer,
                      GridBuffer, FaceBuffer, VertexBuffer, HitBuffer, FoundBuffer>
      trace_ambient_rays;
  opencl::TypedKernel<AeroLaunch, SceneBuffer, SkyTableBuffer, CloudChartBuffer, InstanceBuffer,
                      GridBuffer, FaceBuffer, VertexBuffer, HitBuffer, VisibleBuffer, FoundBuffer,
                      FilmBuffer>
      shade_hits;
  opencl::TypedKernel<FilmBuffer, std::uint32_t> clear_film;
  opencl::TypedKernel<FilmBuffer, AeroConvergence> mark_converged;
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
