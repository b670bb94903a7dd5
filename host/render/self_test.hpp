#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "opencl/device.hpp"
#include "render/session.hpp"
#include "scene/picture.hpp"

/// Finds out whether a device with its driver computes what it should. Drivers miscompile kernels
/// now and then, and a wrong picture is worse than none.
namespace aerostat::render {

/// What a self-test is for.
struct SelfTest {
  /// The lanes of the session, as in Options.
  int lanes = 0;
  scene::Integrator integrator = scene::Integrator::local;
  std::stop_token stop = {};
  /// Is told of the progress, because compiling kernels for the first time takes long.
  ProgressCallback progress = {};
};

/// Renders plates above a plane in the sun, and compares what is met, the distances and the light
/// with closed forms. Returns what is wrong in words, or an empty text if all is right. Throws the
/// errors of Session::render.
std::string fault_of(const opencl::Device& device, const SelfTest& test);

/// Returns the devices of a selector, like opencl::select_devices. Each device is tested before it
/// is used for the first time with its driver and kernels, which is remembered in the user's cache
/// folder. If a device that `auto` stands for fails, the next one is taken, and a warning says so.
/// Throws Error{no_device} if a device that is named fails, or if no device is left.
std::vector<opencl::Device> select_tested(const std::string& selector, const SelfTest& test);

}  // namespace aerostat::render
