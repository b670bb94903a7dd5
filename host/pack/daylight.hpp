#pragma once

#include "core/math.hpp"
#include "scene_params.h"

namespace aerostat::pack {

/// Returns the radiance of a white card that faces the sun at a height in metres above the sea. It
/// is the sunlight through all but the fog (rules/daylight.h) and the mean light of the sky.
dvec3 daylight(const AeroScene& scene, double height_m);

}  // namespace aerostat::pack
