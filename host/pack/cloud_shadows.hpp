#pragma once

#include "pack/shadow_map.hpp"

namespace aerostat::pack {

/// Returns the place of the map of clouds, whose nodes lie at multiples of a cell. `eye` counts
/// from the place of the terrain.
AeroShadowMap place_of_clouds(const AeroCumulus& clouds, const vec3& eye, const SunAxes& axes);

/// Returns the shares of sunlight that heaped clouds leave at their bases, around the point at
/// which a ray from the eye to the sun passes them. They are those of cumulus_shadow() on the
/// device without the clouds' bulges. Nodes lie the same whatever the eye. `sun` is above the
/// horizon.
ShadowMap cloud_shadows(const AeroCumulus& clouds, const vec3& eye, const vec3& sun);

}  // namespace aerostat::pack
