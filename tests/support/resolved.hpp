#pragma once

#include <utility>

#include "scene/balloons.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"

namespace aerostat::test {

/// Returns a resolved scene in which all heights of `scene` count from the sea, whatever the scene
/// says that they count from. No land is carved. Tests use it for scenes in which no land matters,
/// and for resolved scenes of which they changed something.
inline scene::ResolvedScene resolved(scene::Scene scene) {
  for (scene::Balloon* balloon : scene::all_balloons(scene)) {
    balloon->height_above = scene::HeightReference::sea;
  }
  scene.camera.height_above = scene::HeightReference::sea;
  return world::resolve(std::move(scene));
}

}  // namespace aerostat::test
