#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "opencl/cl_names.hpp"

/// Platforms, devices, programs and buffers. Knows no scene.
namespace aerostat::opencl {

enum class DeviceType { cpu, gpu, other };

struct Device {
  std::shared_ptr<const cl::Device> handle;
  int platform_index = 0;  // as in clinfo -l
  int device_index = 0;
  std::string platform, platform_version;
  std::string name;
  std::string driver;
  DeviceType type = DeviceType::other;
  std::uint64_t memory_bytes = 0;  // that its driver reports, or less where the process gets less
  std::string memory_bound;        // what makes it less, in words; empty: nothing does
  std::uint64_t max_allocation_bytes = 0;  // a hint: drivers report it wrongly
  unsigned compute_units = 0;
  unsigned preferred_float_width = 1;
  int lanes = 1;  // rays per work-item that aerostat would use: 1 on GPUs, 4, 8 or 16 on CPUs
  unsigned most_parts = 0;       // that it can be cut into
  unsigned parts = 0, part = 0;  // of how many parts of a device this is which; 0: it is whole

  std::string selector() const;  // "0:1", or "0:1/2.0" for the first of two parts
};

/// What enumeration found: usable devices and, in words, what could not be used and why.
struct DeviceList {
  std::vector<Device> devices;
  std::vector<std::string> problems;
  std::string cache_problem;  // why PoCL was left out (also in `problems`); empty if it was not
  bool has_drivers = false;   // some are registered, whether they can be used or not
  bool lacks_memory = false;  // one of the problems is too little memory
};

/// What a user can do where no device can be used: a clause without a full stop.
std::string advice_without_devices(const DeviceList& list);

/// All devices of all platforms. Never throws because of a platform: broken and empty ones, and
/// registered drivers that cannot be loaded, are described in `problems`. Prepares PoCL's cache
/// folder first (see cache.hpp); if that is impossible, PoCL is left out, since it would fail
/// without a reason or end the process.
DeviceList list_devices();

/// Rays per work-item on a device of `type` that reports these widths of float vectors.
int lanes_for(DeviceType type, unsigned native_width, unsigned preferred_width);

/// The devices of `list` that `selector` names, by the rules of `select_devices`. If a name fits
/// none and PoCL was left out, throws Error{io} that tells how to mend the cache folder.
std::vector<Device> pick(const DeviceList& list, const std::string& selector);

/// One line: "0:1  name (cpu)".
std::string describe(const Device& device);

/// "cpu", "gpu" or "other".
const char* type_name(DeviceType type);

/// The devices that `selector` names, in its order: "all", or names with commas between them. A
/// name is "auto" (a GPU if there is one, else a CPU), "cpu", "gpu", "P:D", or a part of the
/// device's or platform's name (case-insensitive); "" is "auto". Behind it, "/N" cuts the device
/// into N parts of its compute units and takes them all, "/N.K" the K-th of them, counted from 0.
/// Throws Error{no_device} with the list of what there is, or with what to install or mend if
/// nothing is; Error{usage} if the text is malformed or names compute units twice; Error{io} if
/// PoCL's cache folder is the cause; and Error{exhausted} if too little memory is.
std::vector<Device> select_devices(const std::string& selector);

/// The one device that `selector` names. Throws as `select_devices` does, and Error{usage} if they
/// are several.
Device select_device(const std::string& selector);

/// `selector` if not empty, else AEROSTAT_DEVICE, else "auto".
std::string effective_selector(const std::string& selector);

}  // namespace aerostat::opencl
