#pragma once

#include "air/light.hpp"
#include "air_params.h"
#include "scene/scene.hpp"

namespace aerostat::pack {

/// Solves the air of a scene (air::Light) for the eye of its camera and lays it out for the device
/// in `air`. The scattering is taken from the cache or left there.
void pack_air(const scene::Scene& scene, air::ScatteringCache& cache, AeroAir& air);

}  // namespace aerostat::pack
