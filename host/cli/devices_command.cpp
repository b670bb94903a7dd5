#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/scene_input.hpp"
#include "core/error.hpp"
#include "opencl/device.hpp"

namespace aerostat::cli {

namespace {

// Returns the devices that a render would use now, or none if the environment names a device that
// does not exist.
std::vector<opencl::Device> chosen_devices(const opencl::DeviceList& list) {
  try {
    return opencl::pick(list, opencl::effective_selector(""));
  } catch (const Error&) {
    return {};
  }
}

// Returns whether a render would use the device or parts of it.
bool is_among(const opencl::Device& device, const std::vector<opencl::Device>& chosen) {
  return std::any_of(chosen.begin(), chosen.end(), [&](const opencl::Device& one) {
    return one.platform_index == device.platform_index && one.device_index == device.device_index;
  });
}

std::string selectors_of(const std::vector<opencl::Device>& devices) {
  std::string text;
  for (const opencl::Device& device : devices) {
    if (!text.empty()) text += ',';
    text += device.selector();
  }
  return text;
}

std::string cuts_text(const opencl::Device& device) {
  if (device.most_parts < 2) return "";
  const std::string selector = device.selector();
  return fmt::format("     up to {} parts: {}/2 is two halves, {}/2.0 the first of them\n",
                     device.most_parts, selector, selector);
}

std::string bound_text(const opencl::Device& device) {
  return device.memory_bound.empty() ? "" : fmt::format(" (left by {})", device.memory_bound);
}

std::string text_of(const opencl::DeviceList& list, const std::vector<opencl::Device>& chosen) {
  std::string text;
  for (const opencl::Device& device : list.devices) {
    text += fmt::format(
        "{} {}  {}\n     platform {}, driver {}\n     {}, {} compute units, {:.1f} GiB{}, "
        "preferred "
        "float width {}, lanes {}\n",
        is_among(device, chosen) ? "*" : " ", device.selector(), device.name, device.platform,
        device.driver, opencl::type_name(device.type), device.compute_units,
        static_cast<double>(device.memory_bytes) / 0x1p30, bound_text(device),
        device.preferred_float_width, device.lanes);
    text += cuts_text(device);
  }
  for (const std::string& problem : list.problems) text += fmt::format("! {}\n", problem);
  if (list.devices.empty()) {
    text +=
        fmt::format("No OpenCL device can be used: {}.\n", opencl::advice_without_devices(list));
  } else if (!chosen.empty()) {
    text += fmt::format("* {} is taken unless --device or AEROSTAT_DEVICE says otherwise.\n",
                        selectors_of(chosen));
  }
  return text;
}

std::string json_of(const opencl::DeviceList& list, const std::vector<opencl::Device>& chosen) {
  nlohmann::ordered_json devices = nlohmann::ordered_json::array();
  for (const opencl::Device& device : list.devices) {
    devices.push_back({{"selector", device.selector()},
                       {"platform", device.platform},
                       {"name", device.name},
                       {"driver", device.driver},
                       {"type", opencl::type_name(device.type)},
                       {"memory_bytes", device.memory_bytes},
                       {"memory_bound", device.memory_bound},
                       {"max_allocation_bytes", device.max_allocation_bytes},
                       {"compute_units", device.compute_units},
                       {"preferred_float_width", device.preferred_float_width},
                       {"lanes", device.lanes},
                       {"most_parts", device.most_parts},
                       {"chosen", is_among(device, chosen)}});
  }
  const nlohmann::ordered_json all = {{"devices", devices}, {"problems", list.problems}};
  // Names of drivers may contain bytes that are not UTF-8.
  return all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

int devices(const DevicesOptions& options) {
  const opencl::DeviceList list = opencl::list_devices();
  const auto chosen = chosen_devices(list);
  write_stdout(options.json ? json_of(list, chosen) : text_of(list, chosen));
  if (!list.devices.empty()) return 0;
  return static_cast<int>(list.lacks_memory ? ErrorKind::exhausted : ErrorKind::no_device);
}

}  // namespace aerostat::cli
