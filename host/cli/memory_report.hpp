#pragma once

#include <string>
#include <vector>

#include "opencl/device.hpp"
#include "render/memory_need.hpp"

namespace aerostat::cli {

/// Returns lines on what a render needs on each device and what makes that less, and on what each
/// device has.
std::string memory_text(const render::MemoryNeed& need, const std::vector<opencl::Device>& devices);

}  // namespace aerostat::cli
