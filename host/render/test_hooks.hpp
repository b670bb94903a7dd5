#pragma once

#include <functional>

namespace aerostat::opencl {
struct Device;
}
namespace aerostat::pack {
struct PackedScene;
}

namespace aerostat::render {

/// What tests do in the middle of a render. A session that is made without hooks has none.
struct TestHooks {
  /// Is called with the device before each launch, on the thread that launches. An exception that
  /// it throws counts as a failure of the launch.
  std::function<void(const opencl::Device&)> before_launch = {};
  /// Is called with each scene before the devices get it, and may change it.
  std::function<void(pack::PackedScene&)> change_scene = {};
};

}  // namespace aerostat::render
