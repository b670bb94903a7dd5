#include <algorithm>
#include <cctype>
#include <charconv>
#include <functional>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/environment.hpp"
#include "core/error.hpp"
#include "opencl/device.hpp"
#include "opencl/partition.hpp"

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

/// Returns the rules by which a device is searched, the most wanted first.
std::vector<Rule> rules_of(const std::string& wanted) {
  if (is_automatic(wanted)) {
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
    message = "there is no OpenCL device: " + advice_without_devices(list);
  } else {
    message = fmt::format("there is no OpenCL device \"{}\"; there are:", selector);
    for (const auto& device : list.devices) message += "\n  " + describe(device);
  }
  for (const auto& problem : list.problems) message += "\n  not usable: " + problem;
  throw Error(list.lacks_memory ? ErrorKind::exhausted : ErrorKind::no_device, message);
}

/// One name of a selector, split into its parts.
struct Name {
  std::string device;
  /// The number of parts that the device is cut into, or 0 for the whole device.
  unsigned parts = 0;
  std::optional<unsigned> part;
};

std::optional<unsigned> number(std::string_view digits) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const std::string& selector, const std::string& why) {
  throw Error(ErrorKind::usage, fmt::format("device \"{}\": {}", selector, why));
}

/// Splits a name of a selector. Names of devices may contain slashes of their own, so only a slash
/// with numbers behind it cuts the device.
Name parse_name(const std::string& text) {
  Name name;
  name.device = text;
  const auto slash = text.rfind('/');
  const auto cut =
      slash == std::string::npos ? std::string_view() : std::string_view(text).substr(slash + 1);
  if (cut.empty() || cut.find_first_not_of("0123456789.") != std::string_view::npos) return name;
  const auto dot = cut.find('.');
  name.device.resize(slash);
  const auto parts = number(cut.substr(0, dot));
  if (dot != std::string_view::npos) name.part = number(cut.substr(dot + 1));
  const bool is_one = dot == std::string_view::npos || name.part;
  if (!parts || *parts == 0 || !is_one || name.part.value_or(0) >= *parts) {
    refuse(text, "expected DEVICE/N, or DEVICE/N.K with a part K from 0 to N - 1");
  }
  name.parts = *parts;
  return name;
}

bool overlap(const Device& a, const Device& b) {
  if (a.platform_index != b.platform_index || a.device_index != b.device_index) return false;
  return a.parts != b.parts || a.part == b.part;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> items(1);
  for (const char c : text) {
    if (c == ',') {
      items.emplace_back();
    } else {
      items.back() += c;
    }
  }
  return items;
}

const Device& pick_one(const DeviceList& list, const std::string& name) {
  for (const auto& rule : rules_of(lower(name))) {
    const auto found = std::find_if(list.devices.begin(), list.devices.end(), rule);
    if (found != list.devices.end()) return *found;
  }
  throw_nothing_found(list, name);
}

std::vector<Device> pick_named(const DeviceList& list, const std::string& text) {
  if (lower(text) == "all" && !list.devices.empty()) return list.devices;
  const Name name = parse_name(text);
  const Device& device = pick_one(list, name.device);
  if (name.parts == 0) return {device};
  const auto parts = cut(device, name.parts);
  return name.part ? std::vector{parts[*name.part]} : parts;
}

}  // namespace

std::string Device::selector() const {
  const auto whole = fmt::format("{}:{}", platform_index, device_index);
  return parts == 0 ? whole : fmt::format("{}/{}.{}", whole, parts, part);
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

std::string advice_without_devices(const DeviceList& list) {
  if (list.lacks_memory) {
    return "it needs more memory; close other programs, or raise the limit of the process "
           "(ulimit -v) or of its container";
  }
  const char* const install = "install pocl-opencl-icd or your GPU's driver";
  return list.has_drivers ? fmt::format("repair the driver that is registered, or {}", install)
                          : install;
}

std::vector<Device> pick(const DeviceList& list, const std::string& selector) {
  std::vector<Device> picked;
  const auto names = split(selector);
  for (const auto& name : names) {
    if (name.empty() && names.size() > 1)
      refuse(selector, "a name is missing before or after a comma");
    for (const Device& device : pick_named(list, name)) {
      for (const Device& other : picked) {
        if (!overlap(device, other)) continue;
        refuse(selector, fmt::format("{} and {} are the same compute units", other.selector(),
                                     device.selector()));
      }
      picked.push_back(device);
    }
  }
  return picked;
}

bool is_automatic(const std::string& selector) {
  return selector.empty() || lower(selector) == "auto";
}

std::vector<Device> in_order_of_choice(const DeviceList& list) {
  std::vector<Device> devices;
  for (const auto& rule : rules_of("auto")) {
    std::copy_if(list.devices.begin(), list.devices.end(), std::back_inserter(devices), rule);
  }
  return devices;
}

std::vector<Device> select_devices(const std::string& selector) {
  return pick(list_devices(), selector);
}

Device select_device(const std::string& selector) {
  const auto devices = select_devices(selector);
  if (devices.size() > 1) {
    refuse(selector, fmt::format("found {} devices, expected one", devices.size()));
  }
  return devices.front();
}

std::string effective_selector(const std::string& selector) {
  if (!selector.empty()) return selector;
  return environment_variable("AEROSTAT_DEVICE").value_or("auto");
}

}  // namespace aerostat::opencl
