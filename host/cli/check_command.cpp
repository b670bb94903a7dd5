#include <cstdio>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/scene_input.hpp"

namespace aerostat::cli {

int check(const SceneOptions& options) {
  load_scene(options);
  fmt::print(stderr, "{}: ok\n", options.scene.string());
  return 0;
}

}  // namespace aerostat::cli
