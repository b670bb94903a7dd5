#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "opencl/cl_names.hpp"

/// Provides platforms, devices, programs and buffers. It does not know scenes.
namespace aerostat::opencl {

enum class DeviceType { cpu, gpu, other };

struct Device {
  std::shared_ptr<const cl::Device> handle;
  /// The index of the platform, as in clinfo -l.
  int platform_index = 0;
  int device_index = 0;
  std::string platform, platform_version;
  std::string name;
  std::string driver;
  DeviceType type = DeviceType::other;
  /// The memory that the driver reports in bytes, or less if the process can have less.
  std::uint64_t memory_bytes = 0;
  /// A description of what makes the memory less, or an empty string if nothing does.
  std::string memory_bound;
  /// The largest allocation in bytes. It is only a hint, because drivers report it wrongly.
  std::uint64_t max_allocation_bytes = 0;
  unsigned compute_units = 0;
  unsigned preferred_float_width = 1;
  /// The rays per work-item that aerostat would use: 1 on GPUs, and 4, 8 or 16 on CPUs.
  int lanes = 1;
  /// The largest number of parts that the device can be cut into.
  unsigned most_parts = 0;
  /// The number of parts that a device was cut into, and the index of this part. With 0 parts it is
  /// the whole device.
  unsigned parts = 0, part = 0;

  /// Returns the selector, such as "0:1", or "0:1/2.0" for the first of two parts.
  std::string selector() const;
};

/// The result of an enumeration: usable devices, and descriptions of what could not be used and
/// why.
struct DeviceList {
  std::vector<Device> devices;
  std::vector<std::string> problems;
  /// The reason why PoCL was left out, which is also in `problems`. It is empty if PoCL was not
  /// left out.
  std::string cache_problem;
  /// Tells whether any driver is registered, usable or not.
  bool has_drivers = false;
  /// Tells whether one of the problems is a lack of memory.
  bool lacks_memory = false;
};

/// Returns a clause without a full stop that says what a user can do if no device can be used.
std::string advice_without_devices(const DeviceList& list);

/// Returns all devices of all platforms. Never throws because of a platform: `problems` describes
/// broken and empty platforms, and registered drivers that cannot be loaded. Prepares PoCL's cache
/// folder first (see cache.hpp). If that is impossible, PoCL is left out, because it would fail
/// without a reason or end the process.
DeviceList list_devices();

/// Returns the rays per work-item on a device of `type` that reports these widths of float vectors.
int lanes_for(DeviceType type, unsigned native_width, unsigned preferred_width);

/// Returns the devices of `list` that `selector` names, by the rules of `select_devices`. If a name
/// fits none and PoCL was left out, throws Error{io} that tells how to mend the cache folder.
std::vector<Device> pick(const DeviceList& list, const std::string& selector);

/// Returns whether a selector leaves the choice of a device open: whether it is empty or "auto".
bool is_automatic(const std::string& selector);

/// Returns the devices of `list` in the order in which "auto" prefers them.
std::vector<Device> in_order_of_choice(const DeviceList& list);

/// Returns a line such as "0:1  name (cpu)".
std::string describe(const Device& device);

/// Returns "cpu", "gpu" or "other".
const char* type_name(DeviceType type);

/// Returns the devices that `selector` names, in its order. The selector is "all", or names with
/// commas between them. A name is "auto" (a GPU if there is one, else a CPU), "cpu", "gpu", "P:D",
/// or a part of the device's or platform's name in upper or lower case. An empty selector means
/// "auto". After a name, "/N" cuts the device into N parts of its compute units and takes all of
/// them, and "/N.K" takes the part K, counted from 0.
/// Throws Error{no_device} with the list of devices, or with what to install or mend if there are
/// none. Throws Error{usage} if the text is malformed or names compute units twice, Error{io} if
/// PoCL's cache folder is the cause, and Error{exhausted} if there is too little memory.
std::vector<Device> select_devices(const std::string& selector);

/// Returns the only device that `selector` names. Throws as `select_devices` does, and Error{usage}
/// if it names several.
Device select_device(const std::string& selector);

/// Returns `selector` if it is not empty, else AEROSTAT_DEVICE if it is set, else "auto".
std::string effective_selector(const std::string& selector);

}  // namespace aerostat::opencl
