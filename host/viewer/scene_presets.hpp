#pragma once

#include <QString>
#include <vector>

#include "scene/source.hpp"

namespace aerostat::viewer {

/// A camera that a scene file has.
struct ScenePreset {
  QString name;
  scene::SceneSource scene;
};

/// The cameras of the scenes that came with the program, of one biome. Files that cannot be read
/// have none.
std::vector<ScenePreset> scene_presets(scene::BiomeKind biome);

/// `source` with the camera of another scene, and in its basket view the way that the balloon
/// turns.
scene::SceneSource with_camera_of(const scene::SceneSource& source,
                                  const scene::SceneSource& other);

}  // namespace aerostat::viewer
