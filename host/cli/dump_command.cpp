#include "cli/commands.hpp"
#include "cli/scene_input.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::cli {

int dump(const SceneOptions& options) {
  world::ReliefCache reliefs;
  write_stdout(scene::write_text(*load_scene(options, reliefs)));
  return 0;
}

}  // namespace aerostat::cli
