#include "cli/commands.hpp"
#include "cli/scene_input.hpp"
#include "scene/io.hpp"
#include "scene/local_frame.hpp"
#include "scene/outside_view.hpp"
#include "scene/scene.hpp"

namespace aerostat::cli {

int dump(const DumpOptions& options) {
  world::ReliefCache reliefs;
  const scene::ResolvedScene scene = load_scene(options.input, reliefs);
  write_stdout(options.view ? scene::outside_view_text(scene, scene::origin_for_export(scene))
                            : scene::write_text(*scene));
  return 0;
}

}  // namespace aerostat::cli
