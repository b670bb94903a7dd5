#pragma once

#include "scene_params.h"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::ground {

/// Waves shorter than a millimetre are finer than any picture shows, and their number over a land
/// is more than a float holds.
inline constexpr double kShortestWaveM = 1e-3;

/// Returns the numbers of a scene's ground, by which the device paints it and the host places
/// plants.
AeroGround ground_numbers(const scene::Scene& scene);

}  // namespace aerostat::ground
