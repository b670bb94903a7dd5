#include "cli/picture.hpp"

#include <cstdio>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "opencl/device.hpp"
#include "render/development.hpp"

namespace aerostat::cli {

void print_stderr(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

WarningsAbove::WarningsAbove(ProgressBar& bar, bool quiet)
    : former_(set_log_sink(quiet ? LogSink() : LogSink([&bar](const std::string& message) {
        bar.message("aerostat: " + message);
      }))) {}

WarningsAbove::~WarningsAbove() {
  set_log_sink(std::move(former_));
}

render::Options session_options_of(const DeviceOptions& options) {
  render::Options session;
  session.devices = opencl::select_devices(opencl::effective_selector(options.selector));
  session.lanes = options.lanes;
  session.memory_limit_bytes = options.memory_limit_bytes;
  return session;
}

std::string names_of(const std::vector<opencl::Device>& devices) {
  std::map<std::string, int> counts;
  for (const opencl::Device& device : devices) ++counts[device.name];
  std::string text;
  for (const auto& [name, count] : counts) {
    if (!text.empty()) text += " and ";
    text += count == 1 ? name : fmt::format("{} x {}", count, name);
  }
  return text;
}

void warn_of_nan(const image::Film& film) {
  if (film.nan_pixels == 0) return;
  warn(fmt::format("{} pixels were not a number (NaN) and were set to black", film.nan_pixels));
}

image::Pixels develop(const image::Film& film, const scene::Image& image) {
  return image::develop(film, render::development_of(image, film));
}

}  // namespace aerostat::cli
