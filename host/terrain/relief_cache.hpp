#pragma once

#include "core/last_made.hpp"
#include "scene/scene.hpp"
#include "terrain/carving.hpp"

namespace aerostat::terrain {

class Relief;

/// Keeps the relief that was made last for each carving: placing the objects of a scene and
/// building its meshes ask for the same one in turn, and carving it takes longer than anything else
/// about it. A session or a command owns one. It may be used from any thread, and who asks for a
/// coarse relief waits for no fine one.
struct ReliefCache {
  LastMade<scene::Terrain, Relief> fine, coarse;

  LastMade<scene::Terrain, Relief>& of(Carving carving) {
    return carving == Carving::coarse ? coarse : fine;
  }
};

}  // namespace aerostat::terrain
