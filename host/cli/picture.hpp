#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "cli/progress_bar.hpp"
#include "core/log.hpp"
#include "image/write.hpp"
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

/// Returns the options of a session that renders each view once. Finds the devices of the
/// options, or else those of the environment. Throws the errors of opencl::select_devices.
render::Options session_options_of(const DeviceOptions& options);

/// Returns each name once, with the number of devices that have it.
std::string names_of(const std::vector<opencl::Device>& devices);

void warn_of_nan(const image::Film& film);

/// Turns a film into a picture as render::development_of says.
image::Pixels develop(const image::Film& film, const scene::Image& image);

}  // namespace aerostat::cli
