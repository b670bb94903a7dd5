#include "cli/memory_report.hpp"

#include <fmt/format.h>

namespace aerostat::cli {

std::string memory_text(const render::MemoryNeed& need,
                        const std::vector<opencl::Device>& devices) {
  std::string text = fmt::format("memory    {} on each device\n", render::bytes_text(need.bytes()));
  for (const render::MemoryItem& item : need.items) {
    text += fmt::format("  {:<27} {:>10}, less with {}\n", item.what,
                        render::bytes_text(item.bytes), item.remedy);
  }
  for (const opencl::Device& device : devices) {
    const std::string bound = device.memory_bound.empty() ? "" : ", " + device.memory_bound;
    text += fmt::format("device    {} has {}{}\n", opencl::describe(device),
                        render::bytes_text(device.memory_bytes), bound);
  }
  return text;
}

}  // namespace aerostat::cli
