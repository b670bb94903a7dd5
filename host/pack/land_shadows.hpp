#pragma once

#include "mesh/grid_mesh.hpp"
#include "pack/shadow_map.hpp"

namespace aerostat::pack {

/// Returns the heights in metres above the sea below which the ground hides the middle of the sun.
/// `ground` counts from a point that lies at `place` over the terrain. `sun` is the unit vector to
/// the sun, which is not straight above. For each row of nodes along the sun's azimuth there is one
/// sweep over the heights h at intervals d, from the sun's side on:
///   H[i] = max(h[i], H[i + 1] - d tan(elevation))
/// Beyond the ground, h is lower than any ground.
ShadowMap land_shadows(const mesh::GridMesh& ground, const vec3& place, const vec3& sun);

}  // namespace aerostat::pack
