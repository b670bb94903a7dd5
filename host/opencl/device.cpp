#include "opencl/device.hpp"

#include <bit>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/memory_left.hpp"
#include "opencl/cache.hpp"
#include "opencl/partition.hpp"
#include "opencl/registered.hpp"
#include "opencl/status.hpp"

namespace aerostat::opencl {
namespace {

constexpr int kNoIcd = -1001;

/// Runs `f` and returns whether it did not throw. If it throws, notes why `subject` cannot be used.
template <typename F>
bool tolerate(DeviceList& list, const std::string& subject, F&& f) {
  try {
    f();
    return true;
  } catch (const cl::Error& error) {
    list.problems.push_back(fmt::format("{}: {}", subject, status_text(error)));
    list.lacks_memory = list.lacks_memory || is_out_of_memory(error.err());
  } catch (const std::exception& error) {
    list.problems.push_back(fmt::format("{}: {}", subject, error.what()));
    list.lacks_memory = list.lacks_memory || speaks_of_memory(error.what());
  }
  return false;
}

/// Removes the blanks and zero bytes with which drivers pad names.
std::string trimmed(std::string text) {
  if (const auto zero = text.find('\0'); zero != std::string::npos) text.resize(zero);
  const auto first = text.find_first_not_of(" \t\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

DeviceType type_of(cl_device_type bits) {
  if ((bits & CL_DEVICE_TYPE_GPU) != 0) return DeviceType::gpu;
  return (bits & CL_DEVICE_TYPE_CPU) != 0 ? DeviceType::cpu : DeviceType::other;
}

bool is_older_than_1_2(const std::string& version) {
  return version.starts_with("OpenCL 1.0") || version.starts_with("OpenCL 1.1");
}

/// Returns why a device cannot run the kernels, or nothing if it can.
std::optional<std::string> obstacle(const cl::Device& handle) {
  if (!handle.getInfo<CL_DEVICE_AVAILABLE>()) return "the driver says it is not available";
  if (!handle.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) return "its driver has no compiler";
  const auto version = handle.getInfo<CL_DEVICE_VERSION>();
  if (is_older_than_1_2(version)) return fmt::format("{}: 1.2 is needed", trimmed(version));
  const bool little = handle.getInfo<CL_DEVICE_ENDIAN_LITTLE>() != CL_FALSE;
  if (little != (std::endian::native == std::endian::little))
    return "its byte order differs from that of this machine";
  return std::nullopt;
}

Device described(const cl::Device& handle, const cl::Platform& platform, const MemoryLeft& left) {
  Device device;
  device.handle = std::make_shared<cl::Device>(handle);
  device.platform = trimmed(platform.getInfo<CL_PLATFORM_NAME>());
  device.platform_version = trimmed(platform.getInfo<CL_PLATFORM_VERSION>());
  device.name = trimmed(handle.getInfo<CL_DEVICE_NAME>());
  device.driver = trimmed(handle.getInfo<CL_DRIVER_VERSION>());
  device.type = type_of(handle.getInfo<CL_DEVICE_TYPE>());
  device.memory_bytes = handle.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
  if (handle.getInfo<CL_DEVICE_HOST_UNIFIED_MEMORY>() && left.bytes < device.memory_bytes) {
    device.memory_bytes = left.bytes;
    device.memory_bound = left.bound;
  }
  device.max_allocation_bytes = handle.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
  device.compute_units = handle.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
  device.preferred_float_width = handle.getInfo<CL_DEVICE_PREFERRED_VECTOR_WIDTH_FLOAT>();
  device.lanes = lanes_for(device.type, handle.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>(),
                           device.preferred_float_width);
  device.most_parts = most_parts(handle);
  return device;
}

std::vector<cl::Platform> platforms(DeviceList& list) {
  std::vector<cl::Platform> found;
  tolerate(list, "the list of OpenCL platforms", [&] {
    try {
      cl::Platform::get(&found);
    } catch (const cl::Error& error) {
      if (error.err() != kNoIcd) throw;
    }
  });
  return found;
}

/// Adds the problems of registered drivers, which the loader passes over in silence.
void add_registered(DeviceList& list, bool has_platforms) {
  const auto drivers = registered_drivers(VendorEnvironment::of_process());
  list.has_drivers = !drivers.empty();
  if (drivers.empty()) list.problems.emplace_back("no OpenCL driver is registered");
  auto problems = problems_of(drivers, has_platforms);
  std::move(problems.texts.begin(), problems.texts.end(), std::back_inserter(list.problems));
  list.lacks_memory = list.lacks_memory || problems.lack_memory;
}

std::vector<cl::Device> devices_of(const cl::Platform& platform) {
  std::vector<cl::Device> found;
  try {
    platform.getDevices(CL_DEVICE_TYPE_ALL, &found);
  } catch (const cl::Error& error) {
    if (error.err() != CL_DEVICE_NOT_FOUND) throw;
  }
  if (found.empty()) throw std::runtime_error("it has no devices");
  return found;
}

void add_platform(DeviceList& list, const cl::Platform& platform, int platform_index,
                  const std::string& cache_problem) {
  const auto name = trimmed(platform.getInfo<CL_PLATFORM_NAME>());
  const auto label = fmt::format("platform {} ({})", platform_index, name);
  if (!cache_problem.empty() && name == "Portable Computing Language") {
    list.cache_problem = cache_problem;
    list.problems.push_back(fmt::format("{}: {}", label, cache_problem));
    return;
  }
  const MemoryLeft left = memory_left();
  std::vector<cl::Device> handles;
  tolerate(list, label, [&] { handles = devices_of(platform); });
  for (std::size_t i = 0; i < handles.size(); ++i) {
    tolerate(list, fmt::format("device {}:{} of {}", platform_index, i, label), [&] {
      auto device = described(handles[i], platform, left);
      if (const auto reason = obstacle(handles[i])) {
        throw std::runtime_error(fmt::format("{}: {}", device.name, *reason));
      }
      device.platform_index = platform_index;
      device.device_index = static_cast<int>(i);
      list.devices.push_back(std::move(device));
    });
  }
}

}  // namespace

int lanes_for(DeviceType type, unsigned native_width, unsigned preferred_width) {
  if (type != DeviceType::cpu) return 1;
  const unsigned width = native_width > 0 ? native_width : preferred_width;
  if (width >= 16) return 16;
  return width >= 8 ? 8 : 4;
}

DeviceList list_devices() {
  DeviceList list;
  // A driver that finds too little memory ends the process or is killed together with it.
  if (auto obstacle = memory_obstacle(); !obstacle.empty()) {
    list.lacks_memory = true;
    list.problems.push_back(std::move(obstacle));
    return list;
  }
  const auto cache_problem = ensure_pocl_cache();
  const auto found = platforms(list);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const int index = static_cast<int>(i);
    tolerate(list, fmt::format("platform {}", i),
             [&] { add_platform(list, found[i], index, cache_problem); });
  }
  add_registered(list, !found.empty());
  return list;
}

}  // namespace aerostat::opencl
