#pragma once

#include "air/sky.hpp"

namespace aerostat::air {

/// What a renderer needs of the air over a landscape, where light comes from one sun and heights
/// stay below some kilometres: closed forms in the height, and the sky of one eye. All light is per
/// irradiance of the sun outside the air.
struct Light {
  explicit Light(const scene::Scene& scene);

  Atmosphere atmosphere;
  /// Optical depth towards the sun at height h: molecules exp(-h / molecules_height) + haze exp(-h
  /// / haze_height) + ozone.
  dvec3 depth_molecules{0.0}, depth_haze{0.0}, depth_ozone{0.0};
  /// None of the sun's disc is seen from below the first height, all of it from above the second.
  double sun_heights[2] = {0.0, 0.0};
  /// Scattering::around at height h up to kAroundTop: around[0] + around[1] h + around[2] h^2.
  std::array<dvec3, 3> around{};
  SkyTable sky;
  std::array<dvec3, 9> ambient{};

  static constexpr double kAroundTop = 9000.0;

 private:
  Light(const scene::Scene& scene, const Scattering& air);
};

}  // namespace aerostat::air
