#pragma once

#include "pack/pack_scene.hpp"
#include "world/surface.hpp"

namespace aerostat::render {

/// What is kept of the last scene because the next one may need it again: its relief, its air and
/// its chart of clouds. A session owns one; who resolves scenes before they are rendered shares one
/// with the session. It may be used from any thread.
struct SceneCache {
  world::ReliefCache reliefs;
  pack::PackCache packing;
};

}  // namespace aerostat::render
