#include "viewer/scene_presets.hpp"

#include "core/error.hpp"
#include "scene/field_rule.hpp"
#include "scene/installed.hpp"
#include "scene/scene.hpp"

namespace aerostat::viewer {
namespace {

/// Returns the cameras of all installed scenes. The files are read once.
const std::vector<ScenePreset>& all_presets() {
  static const std::vector<ScenePreset> presets = [] {
    std::vector<ScenePreset> found;
    for (const scene::InstalledScene& one : scene::installed_scenes()) {
      try {
        found.push_back({QString::fromStdString(one.name),
                         scene::SceneSource::from_file(scene::find_scene(one.name))});
      } catch (const Error&) {
        // A broken file is skipped here. When it is opened by hand, its error is reported.
        continue;
      }
    }
    return found;
  }();
  return presets;
}

}  // namespace

std::vector<ScenePreset> scene_presets(scene::BiomeKind biome) {
  std::vector<ScenePreset> presets;
  for (const ScenePreset& preset : all_presets()) {
    // A camera over real land would stand in the hills of other land.
    const scene::Scene& scene = preset.scene.scene();
    if (scene.terrain.kind == scene::TerrainKind::elevation) continue;
    if (scene.biome.kind == biome) presets.push_back(preset);
  }
  return presets;
}

scene::SceneSource with_camera_of(const scene::SceneSource& source,
                                  const scene::SceneSource& other) {
  std::vector<std::string> pointers;
  for (const std::string& pointer : scene::field_pointers()) {
    if (pointer.starts_with("/camera/")) pointers.push_back(pointer);
  }
  const bool basket = other.scene().camera.view == scene::View::basket;
  if (basket) pointers.emplace_back("/balloon/heading_deg");
  std::vector<scene::Override> changes;
  for (const std::string& pointer : pointers) {
    if (other.differs(pointer)) changes.push_back({pointer, other.value(pointer)});
  }
  return source.without(pointers).with(changes);
}

}  // namespace aerostat::viewer
