#pragma once

#include "air_params.h"
#include "scene/scene.hpp"

namespace aerostat::pack {

/// Solves the air of a scene (air::Light) for the eye of its camera and lays it out for the device
/// in `air`.
void pack_air(const scene::Scene& scene, AeroAir& air);

}  // namespace aerostat::pack
