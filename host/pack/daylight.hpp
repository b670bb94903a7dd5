#pragma once

#include "core/math.hpp"
#include "scene_params.h"

namespace aerostat::pack {

/// Radiance of a white card that faces the sun at a height above the sea: sunlight through the air
/// and what comes from the sky on average.
dvec3 daylight(const AeroScene& scene, double height_m);

}  // namespace aerostat::pack
