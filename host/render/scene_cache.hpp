#pragma once

#include "pack/pack_scene.hpp"
#include "world/scene_models.hpp"
#include "world/surface.hpp"

namespace aerostat::render {

/// Keeps the relief, the models from files, the air and the chart of clouds of the last scene,
/// because the next scene may need them again. A session owns one. A caller that resolves scenes
/// before they are rendered shares its cache with the session. It may be used from any thread.
struct SceneCache {
  world::ReliefCache reliefs;
  world::ModelCache models;
  pack::PackCache packing;
};

}  // namespace aerostat::render
