#include <cstdio>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/scene_input.hpp"

namespace aerostat::cli {

int check(const SceneOptions& options) {
  world::ReliefCache reliefs;
  load_scene(options, reliefs);
  fmt::print(stderr, "{}: ok\n", name_of_scene(options));
  return 0;
}

}  // namespace aerostat::cli
