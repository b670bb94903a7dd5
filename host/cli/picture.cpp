#include "cli/picture.hpp"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "cli/parse.hpp"
#include "cli/progress_text.hpp"
#include "core/duration.hpp"
#include "core/environment.hpp"
#include "core/error.hpp"
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

namespace {

/// Returns the seconds after which a device counts as lost, or 0 for never.
double device_timeout_s() {
  const auto text = environment_variable(kDeviceTimeoutVariable);
  if (!text) return render::Options().device_timeout_s;
  if (*text == "0") return 0.0;
  return parse_duration(*text, kDeviceTimeoutVariable);
}

/// Ends the process. Threads of the driver may hang, so that nothing else is certain to end it.
/// Files are written in such a way that nothing of them is left behind.
[[noreturn]] void give_up_device(double seconds) {
  print_stderr(
      fmt::format("aerostat: the device has not answered for {} and is given up; nothing "
                  "more is written ({} changes the time)\n",
                  duration_text(seconds), kDeviceTimeoutVariable));
  std::_Exit(static_cast<int>(ErrorKind::exhausted));
}

}  // namespace

render::Options session_options_of(const DeviceOptions& options, const render::SelfTest& test) {
  render::Options session;
  const std::string selector = opencl::effective_selector(options.selector);
  render::SelfTest own = test;
  own.lanes = options.lanes;
  session.devices = options.skip_self_test ? opencl::select_devices(selector)
                                           : render::select_tested(selector, own);
  session.lanes = options.lanes;
  session.device_timeout_s = device_timeout_s();
  if (session.device_timeout_s > 0.0) {
    session.on_device_timeout = [seconds = session.device_timeout_s] { give_up_device(seconds); };
  }
  session.memory_limit_bytes = options.memory_limit_bytes;
  return session;
}

render::SelfTest self_test_of(scene::Integrator integrator, const std::stop_token& stop,
                              ProgressBar& bar) {
  render::SelfTest test;
  test.integrator = integrator;
  test.stop = stop;
  test.progress = [&bar](const render::Progress& progress) {
    if (progress.stage == render::Stage::kernels) bar.update(progress);
  };
  return test;
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
