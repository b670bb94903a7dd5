#pragma once

#include <vector>

#include "air/sun_paths.hpp"

namespace aerostat::air {

/// A way through the air: from a height above the sea in a direction (unit, y up where it starts).
struct Way {
  double height = 0.0;
  dvec3 direction{0.0, 1.0, 0.0};
  double length = 0.0;
};

/// What a way through sunlit air adds to what comes from its end, per irradiance of the sun outside
/// the air: radiance = add + haze * haze_phase(cosine to the sun) + transmittance * (what is
/// behind).
struct PathLight {
  dvec3 add{0.0};
  dvec3 haze{0.0};
  dvec3 transmittance{1.0};
};

/// The sunlit air. `sun` is a unit vector; all light is per irradiance of the sun outside the air.
class Scattering {
 public:
  Scattering(const Atmosphere& air, const dvec3& sun);

  const Atmosphere& atmosphere() const { return air_; }
  const SunPaths& sun_paths() const { return paths_; }
  const dvec3& sun() const { return sun_; }

  /// Irradiance of a plane that faces the sun, whose direction's cosine with the upright there is
  /// given.
  dvec3 sunlight(double height, double sun_cosine) const;

  /// Mean over all directions of the light that was scattered before: every order but the first,
  /// taken as even in direction. For cosines within 0.2 of the sun's at the start. Source: S.
  /// Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique" (EGSR
  /// 2020), section 5.
  dvec3 around(double height, double sun_cosine) const;

  /// Single scattering along the way, with `around` as light of the later orders. The steps get
  /// longer along the way; in each the light is even and the extinction exact.
  PathLight follow(const Way& way, int steps) const;

 private:
  Atmosphere air_;
  SunPaths paths_;
  dvec3 sun_;
  std::vector<dvec3> around_;
};

/// Length of the way to the end of the air, or to the ground if that is met first.
double way_to_the_end(double height, double cosine);

/// Whether a direction from that height meets the ground.
bool meets_ground(double height, double cosine);

/// Even part of the light that fog scatters, per steradian and sunlight that reaches it:
/// Eddington's for a thick conservative layer, 3 / (4 pi) mu (mu + 2/3) with mu the cosine of the
/// sun.
double fog_glow(double sun_cosine);

/// Share of the fog's light that still knows where the sun is, by haze_phase of kFogAsymmetry.
inline constexpr double kFogDirect = 0.25;

}  // namespace aerostat::air
