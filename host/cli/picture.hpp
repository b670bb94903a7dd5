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
#include "scene/scene.hpp"

/// What the commands that render share.
namespace aerostat::cli {

void print_stderr(std::string_view text);

/// Lets the library's warnings pass above the bar while it lives; none if quiet.
class WarningsAbove {
 public:
  WarningsAbove(ProgressBar& bar, bool quiet);
  ~WarningsAbove();
  WarningsAbove(const WarningsAbove&) = delete;
  WarningsAbove& operator=(const WarningsAbove&) = delete;

 private:
  LogSink former_;
};

/// For pictures of one view each. Finds the devices: those of the options, or else of the
/// environment. Throws as opencl::select_devices does.
render::Options session_options_of(const DeviceOptions& options);

/// Each name once, with how many devices bear it.
std::string names_of(const std::vector<opencl::Device>& devices);

void warn_of_nan(const image::Film& film);

/// As render::look_of says.
image::Pixels develop(const image::Film& film, const scene::Image& image);

}  // namespace aerostat::cli
