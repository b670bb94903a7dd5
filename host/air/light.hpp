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
  /// What counts as depth_haze for the light that the air scatters.
  dvec3 scattered_depth_haze{0.0};
  /// None of the sun's disc is seen from below the first height, all of it from above the second.
  double sun_heights[2] = {0.0, 0.0};
  /// Scattering::around where landscapes are: even[0] + even[1] x + even[2] x^2, at least
  /// around_least, and likewise slant. x, 0 to around_top, is the height in metres; where
  /// thick_haze, the share by which the haze is thinner than at the sea, 1 - exp(-h / haze_height).
  std::array<dvec3, 3> around{}, around_slant{};
  dvec3 around_least{0.0};
  double around_top = kAroundTop;
  bool thick_haze = false;
  SkyTable sky;
  std::array<dvec3, 9> ambient{};

  static constexpr double kAroundTop = 9000.0;

 private:
  Light(const scene::Scene& scene, const Scattering& air);
  void take_around(const Scattering& air, double eye_height);
};

}  // namespace aerostat::air
