#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "cli/progress_bar.hpp"
#include "core/log.hpp"
#include "image/write.hpp"
#include "render/self_test.hpp"
#include "render/session.hpp"
#include "scene/picture.hpp"

/// These functions are shared by the commands that render.
namespace aerostat::cli {

void print_stderr(std::string_view text);

/// Prints the library's warnings above the progress bar while the object lives. Prints none if
/// `quiet` is true.
class WarningsAbove {
 public:
  WarningsAbove(ProgressBar& bar, bool quiet);
  ~WarningsAbove();
  WarningsAbove(const WarningsAbove&) = delete;
  WarningsAbove& operator=(const WarningsAbove&) = delete;

 private:
  LogSink former_;
};

/// Returns the options of a session that renders each view once. Finds the devices of the options,
/// or else those of the environment, and tests those that are used for the first time. Throws the
/// errors of render::select_tested.
render::Options session_options_of(const DeviceOptions& options, const render::SelfTest& test);

/// Returns a self-test that shows on the bar that kernels are being compiled.
render::SelfTest self_test_of(scene::Integrator integrator, const std::stop_token& stop,
                              ProgressBar& bar);

/// Returns each name once, with the number of devices that have it.
std::string names_of(const std::vector<opencl::Device>& devices);

void warn_of_nan(const image::Film& film);

/// Turns a film into a picture as render::development_of says.
image::Pixels develop(const image::Film& film, const scene::Image& image);

}  // namespace aerostat::cli
