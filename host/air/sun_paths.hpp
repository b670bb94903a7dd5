#pragma once

#include <vector>

#include "air/atmosphere.hpp"

namespace aerostat::air {

/// Densities integrated along a way, in metres of the densest: what the light passes.
struct Columns {
  double molecules = 0.0;
  double haze = 0.0;
  double ozone = 0.0;
};

/// What lies between each height and the top of the air, in each direction: the table of
/// transmittances of E. Bruneton and F. Neyret, "Precomputed Atmospheric Scattering" (EGSR 2008),
/// kept as columns, which interpolate better than their exponentials. Fog is not in it.
class SunPaths {
 public:
  explicit SunPaths(const Atmosphere& air);

  /// Towards a direction whose cosine with the upright is given. Directions that meet the ground
  /// give what lies along the horizon: how much of the sun is up is asked of sun_share.
  Columns columns(double height, double cosine) const;

  /// Of light from there, per channel, through all but the fog.
  dvec3 transmittance(double height, double cosine) const;

  /// The same for haze of another extinction.
  dvec3 transmittance(double height, double cosine, const dvec3& haze_extinction) const;

  /// Minus the logarithm of that.
  dvec3 depth(double height, double cosine, const dvec3& haze_extinction) const;

 private:
  /// By how much more haze a column holds in the table than in the air: where haze is a thin layer,
  /// columns are kept as if each began at the sea's density, which changes little with height.
  double thin_layer(double height) const;

  Atmosphere air_;
  std::vector<Columns> table_;
};

/// Share of the sun's disc above the horizon of a height, 0 to 1.
double sun_share(double height, double cosine);

/// Share of the sunlight that comes down into the fog at a height: what a conservative medium lets
/// diffuse through, 1 / (1 + 3/4 (1 - g) tau) by the two-stream approximation, tau along the way to
/// the sun. `sun_cosine` is that with the upright.
double fog_light(const FogLayer& fog, double height, double sun_cosine);

inline constexpr double kFogAsymmetry = 0.8;
inline constexpr double kLowestFogSun = 0.05;  // as cosine; lower suns go no farther through fog

}  // namespace aerostat::air
