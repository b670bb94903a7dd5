#include "cli/scene_input.hpp"

#include "image/write.hpp"
#include "scene/installed.hpp"
#include "scene/io.hpp"
#include "world/world.hpp"

namespace aerostat::cli {

scene::Scene read_scene(const SceneOptions& options) {
  std::vector<scene::Override> overrides;
  for (const std::string& text : options.overrides) {
    overrides.push_back(scene::parse_override(text));
  }
  return scene::read_file(scene::find_scene(options.scene), overrides);
}

scene::Scene load_scene(const SceneOptions& options) {
  scene::Scene scene = read_scene(options);
  world::resolve(scene);
  return scene;
}

void write_stdout(const std::string& text) {
  image::write_file("/dev/stdout",
                    {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace aerostat::cli
