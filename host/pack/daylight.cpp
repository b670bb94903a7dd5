#include "pack/daylight.hpp"

#include <numbers>

#include "rules/daylight.h"

namespace aerostat::pack {

dvec3 daylight(const AeroScene& scene, double height_m) {
  const AeroAir& air = scene.air;
  const double molecules = rules::density_share(height_m, air.molecules_height);
  const double haze = rules::density_share(height_m, air.haze_height);
  const double share = rules::sun_share(&air, height_m) / std::numbers::pi;
  dvec3 light;
  for (int i = 0; i < 3; ++i) {
    const double sun = share * rules::sun_transmittance(&air, air.depth_haze, molecules, haze, i);
    const double sky = air.ambient[0][i] * (scene.sky.is_even ? 1.0 : scene.sky.sun_irradiance[i]);
    light[i] = scene.sky.sun_irradiance[i] * sun + sky;
  }
  return light;
}

}  // namespace aerostat::pack
