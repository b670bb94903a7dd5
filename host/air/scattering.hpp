#pragma once

#include <optional>
#include <vector>

#include "air/haze_light.hpp"

namespace aerostat::air {

/// A path through the air. It starts at a height above the sea and has a unit direction, with y
/// up at the start.
struct Way {
  double height = 0.0;
  dvec3 direction{0.0, 1.0, 0.0};
  double length = 0.0;
};

/// The light that sunlit air adds along a path, per irradiance of the sun outside the air. The
/// radiance at the start of the path is
///   add + haze * haze_phase(cosine to the sun) + transmittance * (radiance behind)
struct PathLight {
  dvec3 add{0.0};
  dvec3 haze{0.0};
  dvec3 transmittance{1.0};
};

/// The sunlit air. `sun` is a unit vector. All light is per irradiance of the sun outside the
/// air.
class Scattering {
 public:
  Scattering(const Atmosphere& air, const dvec3& sun);

  const Atmosphere& atmosphere() const { return air_; }
  const SunPaths& sun_paths() const { return paths_; }
  const dvec3& sun() const { return sun_; }

  /// Returns the irradiance of a plane that faces the sun. `sun_cosine` is the cosine of the sun
  /// with the upright at that place.
  dvec3 sunlight(double height, double sun_cosine) const;

  /// Returns the part of `sunlight` that the air scatters. In thick haze, it includes light that
  /// was only scattered forwards.
  dvec3 scattered_sunlight(double height, double sun_cosine) const;

  /// Returns the light of every order of scattering but the first. `sun_cosine` must be within
  /// 0.2 of the cosine that the constructor was given. In thin haze, the light is even: S.
  /// Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique" (EGSR
  /// 2020), section 5. Thick haze follows HazeLight.
  HazeLight::Field around(double height, double sun_cosine) const;

  /// Returns the share, 0 to 1, to which haze counts as thick (see thick_haze_share).
  double thick_share() const { return thick_share_; }

  /// Computes single scattering along a path, with `around` as the light of later orders. Steps
  /// get longer along the path. In each step, the light is even and the extinction exact.
  PathLight follow(const Way& way, int steps) const;

 private:
  HazeLight::Field spectral_around(double height, double sun_cosine) const;
  dvec3 even_around(double height, double sun_cosine) const;

  Atmosphere air_;
  SunPaths paths_;
  dvec3 sun_;
  std::vector<dvec3> around_;
  double thick_share_;
  dvec3 scattered_extinction_;  // extinction of haze for light that is scattered
  std::optional<HazeLight> haze_light_;
};

/// Returns the length of the path to the end of the air, or to the ground if the path meets that.
double way_to_the_end(double height, double cosine);

/// Returns whether a direction from that height meets the ground.
bool meets_ground(double height, double cosine);

/// Returns the even part of the light that fog scatters, per steradian and per sunlight that
/// reaches it. It is Eddington's solution for a thick conservative layer, where mu is the cosine
/// of the sun:
///   3 / (4 pi) mu (mu + 2/3)
double fog_glow(double sun_cosine);

/// The share of the fog's light that still depends on the direction of the sun, by haze_phase
/// with kFogAsymmetry.
inline constexpr double kFogDirect = 0.25;

}  // namespace aerostat::air
