#pragma once

#include "opencl/program.hpp"

namespace aerostat::render {

/// The kernels that make a picture, built for one device and lane width.
struct Programs {
  cl::Kernel trace_camera_rays;
  cl::Kernel trace_shadow_rays;
  cl::Kernel shade_hits;
  cl::Kernel clear_film;
  double seconds = 0.0;  // that building took
};

/// Builds them, on several threads. Throws Error{internal} with the build log.
Programs build_programs(const opencl::Context& context, int lanes);

}  // namespace aerostat::render
