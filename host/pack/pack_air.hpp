#pragma once

#include <vector>

#include "air/light.hpp"
#include "air_params.h"
#include "night_params.h"
#include "scene/resolved_scene.hpp"

namespace aerostat::pack {

/// The air of a scene for the device: its numbers, what is seen behind it, and the buffer of the
/// sky (see PackedScene).
struct PackedAir {
  AeroAir numbers{};
  AeroNight night{};
  std::vector<AeroSkyCell> sky_table;
};

/// Returns the AERO_SKY_CELLS cells of a sky.
std::vector<AeroSkyCell> pack_sky_table(const air::SkyTable& table);

/// Solves the air of a scene (air::Light) for the eye of its camera and lays it out for the device.
/// The scattering is taken from the cache or left there.
PackedAir pack_air(const scene::ResolvedScene& scene, air::ScatteringCache& cache);

}  // namespace aerostat::pack
