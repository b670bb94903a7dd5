#pragma once

#include "scene/land.hpp"

namespace aerostat::scene {

/// Returns a biome whose waves are those at time 0. Nothing but their look depends on the time.
inline Biome at_rest(Biome biome) {
  biome.water.time_s = 0.0;
  return biome;
}

}  // namespace aerostat::scene
