#pragma once

#include <vector>

#include "air/light.hpp"
#include "air_params.h"
#include "scene/resolved_scene.hpp"

namespace aerostat::pack {

/// The air of a scene for the device: its numbers, and the AERO_SKY_CELLS cells of the sky's table.
struct PackedAir {
  AeroAir numbers{};
  std::vector<AeroSkyCell> sky_table;
};

/// Solves the air of a scene (air::Light) for the eye of its camera and lays it out for the device.
/// The scattering is taken from the cache or left there.
PackedAir pack_air(const scene::ResolvedScene& scene, air::ScatteringCache& cache);

}  // namespace aerostat::pack
