#pragma once

#include <QString>
#include <vector>

#include "scene/source.hpp"

namespace aerostat::viewer {

/// A camera of a scene file.
struct ScenePreset {
  QString name;
  scene::SceneSource scene;
};

/// Returns the cameras of the installed scenes of one biome. Files that cannot be read are left
/// out.
std::vector<ScenePreset> scene_presets(scene::BiomeKind biome);

/// Returns `source` with the camera of another scene. For a view from the basket, the turn of the
/// balloon is taken over as well.
scene::SceneSource with_camera_of(const scene::SceneSource& source,
                                  const scene::SceneSource& other);

}  // namespace aerostat::viewer
