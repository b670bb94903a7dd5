#pragma once

#include <vector>

#include "opencl/cl_names.hpp"
#include "opencl/device.hpp"

namespace aerostat::opencl {

/// Returns the largest number of parts into which the driver can cut `handle` (clCreateSubDevices,
/// by counts), or 0 if it cuts no devices.
unsigned most_parts(const cl::Device& handle);

/// Returns the compute units of each of `parts` > 0 parts of `units` units. They are as even as
/// possible, with the larger shares first.
std::vector<unsigned> even_shares(unsigned units, unsigned parts);

/// Cuts `device` into `parts` > 0 parts. They compute at the same time, each on its own compute
/// units and in the memory of the whole. Throws Error{no_device} if the driver cannot do this.
std::vector<Device> cut(const Device& device, unsigned parts);

}  // namespace aerostat::opencl
