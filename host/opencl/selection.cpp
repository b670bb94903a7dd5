#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "opencl/device.hpp"

namespace aerostat::opencl {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool is_position(std::string_view selector) {
  const auto colon = selector.find(':');
  if (colon == std::string_view::npos || colon == 0 || colon + 1 == selector.size()) return false;
  const auto is_number = [](std::string_view text) {
    return text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  return is_number(selector.substr(0, colon)) && is_number(selector.substr(colon + 1));
}

using Rule = std::function<bool(const Device&)>;

Rule of_type(DeviceType type) {
  return [type](const Device& device) { return device.type == type; };
}

/// What to look for, the most wanted first.
std::vector<Rule> rules_of(const std::string& wanted) {
  if (wanted.empty() || wanted == "auto") {
    return {of_type(DeviceType::gpu), of_type(DeviceType::cpu), of_type(DeviceType::other)};
  }
  if (wanted == "cpu") return {of_type(DeviceType::cpu)};
  if (wanted == "gpu") return {of_type(DeviceType::gpu)};
  if (is_position(wanted)) {
    return {[wanted](const Device& device) { return device.selector() == wanted; }};
  }
  return {[wanted](const Device& device) {
            return lower(device.name).find(wanted) != std::string::npos;
          },
          [wanted](const Device& device) {
            return lower(device.platform).find(wanted) != std::string::npos;
          }};
}

[[noreturn]] void throw_nothing_found(const DeviceList& list, const std::string& selector) {
  if (!list.cache_problem.empty()) throw Error(ErrorKind::io, list.cache_problem);
  std::string message;
  if (list.devices.empty()) {
    message = "there is no OpenCL device: install pocl-opencl-icd or your GPU's driver";
  } else {
    message = fmt::format("there is no OpenCL device \"{}\"; there are:", selector);
    for (const auto& device : list.devices) message += "\n  " + describe(device);
  }
  for (const auto& problem : list.problems) message += "\n  not usable: " + problem;
  throw Error(ErrorKind::no_device, message);
}

}  // namespace

std::string Device::selector() const {
  return fmt::format("{}:{}", platform_index, device_index);
}

const char* type_name(DeviceType type) {
  switch (type) {
    case DeviceType::cpu:
      return "cpu";
    case DeviceType::gpu:
      return "gpu";
    case DeviceType::other:
      break;
  }
  return "other";
}

std::string describe(const Device& device) {
  return fmt::format("{}  {} ({})", device.selector(), device.name, type_name(device.type));
}

const Device& pick(const DeviceList& list, const std::string& selector) {
  for (const auto& rule : rules_of(lower(selector))) {
    const auto found = std::find_if(list.devices.begin(), list.devices.end(), rule);
    if (found != list.devices.end()) return *found;
  }
  throw_nothing_found(list, selector);
}

Device select_device(const std::string& selector) {
  return pick(list_devices(), selector);
}

std::string effective_selector(const std::string& selector) {
  if (!selector.empty()) return selector;
  const char* variable = std::getenv("AEROSTAT_DEVICE");
  return variable != nullptr && *variable != '\0' ? variable : "auto";
}

}  // namespace aerostat::opencl
