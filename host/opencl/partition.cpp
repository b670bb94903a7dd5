#include "opencl/partition.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"
#include "opencl/status.hpp"

namespace aerostat::opencl {
namespace {

[[noreturn]] void refuse(const Device& device, unsigned parts, const std::string& why) {
  throw Error(ErrorKind::no_device, fmt::format("the device {} cannot be cut into {} parts: {}",
                                                describe(device), parts, why));
}

}  // namespace

unsigned most_parts(const cl::Device& handle) {
  const auto kinds = handle.getInfo<CL_DEVICE_PARTITION_PROPERTIES>();
  if (std::find(kinds.begin(), kinds.end(), CL_DEVICE_PARTITION_BY_COUNTS) == kinds.end()) return 0;
  return std::min(handle.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>(),
                  handle.getInfo<CL_DEVICE_PARTITION_MAX_SUB_DEVICES>());
}

std::vector<unsigned> even_shares(unsigned units, unsigned parts) {
  std::vector<unsigned> shares(parts, units / parts);
  std::for_each_n(shares.begin(), units % parts, [](unsigned& share) { ++share; });
  return shares;
}

std::vector<Device> cut(const Device& device, unsigned parts) {
  if (device.most_parts == 0) refuse(device, parts, "its driver does not support that");
  if (parts > device.most_parts) {
    refuse(device, parts, fmt::format("at most {} are possible", device.most_parts));
  }
  const auto shares = even_shares(device.compute_units, parts);
  std::vector<cl_device_partition_property> how = {CL_DEVICE_PARTITION_BY_COUNTS};
  how.insert(how.end(), shares.begin(), shares.end());
  how.insert(how.end(), {CL_DEVICE_PARTITION_BY_COUNTS_LIST_END, 0});
  std::vector<cl::Device> handles;
  try {
    cl::Device(*device.handle).createSubDevices(how.data(), &handles);
  } catch (const cl::Error& error) {
    if (is_exhaustion(error.err())) {
      rethrow(fmt::format("cutting the device {}", describe(device)).c_str(), error);
    }
    refuse(device, parts, status_text(error));
  }
  std::vector<Device> cut_parts(handles.size(), device);
  for (unsigned i = 0; i < cut_parts.size(); ++i) {
    cut_parts[i].handle = std::make_shared<cl::Device>(handles[i]);
    cut_parts[i].compute_units = shares[i];
    cut_parts[i].most_parts = 0;
    cut_parts[i].parts = parts;
    cut_parts[i].part = i;
  }
  return cut_parts;
}

}  // namespace aerostat::opencl
