#pragma once

#include <vector>

#include "air/atmosphere.hpp"

namespace aerostat::air {

/// Densities integrated along a path, in metres of the greatest density.
struct Columns {
  double molecules = 0.0;
  double haze = 0.0;
  double ozone = 0.0;
};

/// The columns between each height and the top of the air in each direction. They are the table
/// of transmittances of E. Bruneton and F. Neyret, "Precomputed Atmospheric Scattering" (EGSR
/// 2008), kept as columns, which interpolate better than their exponentials. Fog is not included.
class SunPaths {
 public:
  explicit SunPaths(const Atmosphere& air);

  /// Returns the columns towards a direction whose cosine with the upright is given. Directions
  /// that meet the ground get the columns along the horizon. sun_share tells how much of the sun
  /// is up.
  Columns columns(double height, double cosine) const;

  /// Returns the transmittance of light from that direction in each channel, through all but the
  /// fog.
  dvec3 transmittance(double height, double cosine) const;

  /// Returns the transmittance through all but the fog, with another extinction of the haze.
  dvec3 transmittance(double height, double cosine, const dvec3& haze_extinction) const;

  /// Returns the optical depth, which is minus the logarithm of the transmittance.
  dvec3 depth(double height, double cosine, const dvec3& haze_extinction) const;

 private:
  /// Returns the factor by which a column of haze is larger in the table than in the air. If haze
  /// is a thin layer, columns are kept as if each began at the sea's density, because such
  /// columns change little with height.
  double thin_layer(double height) const;

  Atmosphere air_;
  std::vector<Columns> table_;
};

/// Returns the share, 0 to 1, of the sun's disc that is above the horizon of a height.
double sun_share(double height, double cosine);

/// Returns the share of the sunlight that comes down into the fog at a height. It is the diffuse
/// transmittance of a conservative medium by the two-stream approximation, where g is
/// kFogAsymmetry and tau the optical depth along the path to the sun:
///   1 / (1 + 3/4 (1 - g) tau)
/// `sun_cosine` is the cosine of the sun with the upright.
double fog_light(const FogLayer& fog, double height, double sun_cosine);

inline constexpr double kFogAsymmetry = 0.8;
inline constexpr double kLowestFogSun = 0.05;  // a cosine; lower suns count as this one

}  // namespace aerostat::air
