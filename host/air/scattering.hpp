#pragma once

#include <optional>
#include <vector>

#include "air/haze_light.hpp"

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

  /// The part of `sunlight` that the air scatters: in thick haze also what was scattered forwards
  /// only.
  dvec3 scattered_sunlight(double height, double sun_cosine) const;

  /// Light that was scattered before: every order but the first. For cosines within 0.2 of the
  /// sun's at the start. In thin haze it is even: S. Hillaire, "A Scalable and Production Ready Sky
  /// and Atmosphere Rendering Technique" (EGSR 2020), section 5; thick haze follows HazeLight.
  HazeLight::Field around(double height, double sun_cosine) const;

  /// By how much haze is thick, 0 to 1: thick_haze_share.
  double thick_share() const { return thick_share_; }

  /// Single scattering along the way, with `around` as light of the later orders. The steps get
  /// longer along the way; in each the light is even and the extinction exact.
  PathLight follow(const Way& way, int steps) const;

 private:
  HazeLight::Field spectral_around(double height, double sun_cosine) const;
  dvec3 even_around(double height, double sun_cosine) const;

  Atmosphere air_;
  SunPaths paths_;
  dvec3 sun_;
  std::vector<dvec3> around_;
  double thick_share_;
  dvec3 scattered_extinction_;  // of haze, for what is scattered
  std::optional<HazeLight> haze_light_;
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
