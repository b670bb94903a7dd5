#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "aerostat/export.hpp"

namespace aerostat {

/// An OpenCL device that can render.
struct DeviceInfo {
  std::string selector;  ///< name of the device for SessionOptions::device, such as "0:1"
  std::string name;
  std::string platform;
  std::string driver;              ///< version of the driver
  std::string type;                ///< "cpu", "gpu" or "other"
  std::uint64_t memory_bytes = 0;  ///< memory as the driver reports it
  unsigned compute_units = 0;
  int lanes = 1;  ///< rays that a work-item traces together by default
};

/// Returns all devices of all platforms that work. Platforms that are broken are left out and
/// reported to the handler of warnings. Never throws because of a platform.
AEROSTAT_API std::vector<DeviceInfo> list_devices();

}  // namespace aerostat
