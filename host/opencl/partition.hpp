#pragma once

#include <vector>

#include "opencl/cl_names.hpp"
#include "opencl/device.hpp"

namespace aerostat::opencl {

/// Into how many parts the driver lets `handle` be cut (clCreateSubDevices, by counts); 0 if it
/// cuts no devices.
unsigned most_parts(const cl::Device& handle);

/// How `units` compute units are shared out to `parts` > 0 parts: as evenly as they go, the larger
/// shares first.
std::vector<unsigned> even_shares(unsigned units, unsigned parts);

/// `device` cut into `parts` > 0 parts, which compute beside each other, each on its own compute
/// units and in the memory of the whole. Throws Error{no_device} if the driver cannot.
std::vector<Device> cut(const Device& device, unsigned parts);

}  // namespace aerostat::opencl
