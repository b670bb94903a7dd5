#pragma once

#include <functional>
#include <vector>

#include "air/sun_paths.hpp"

namespace aerostat::air {

/// Light inside haze that is too thick for light to leave it after a few scatterings: diffusion in
/// level layers (Eddington's approximation), which keeps all light that is not absorbed. Haze
/// deflects so little that its scattering counts as (1 - asymmetry) of an even one (the similarity
/// relation); light that was scattered forwards only counts as sunlight still. Source: H. C. van de
/// Hulst, "Multiple Light Scattering" (1980), chapter 14. All light is per irradiance of the sun
/// outside the air.
class HazeLight {
 public:
  /// Light of the air without haze by height and cosine of the sun, mean over all directions.
  using ClearLight = std::function<dvec3(double, double)>;

  struct Field {
    dvec3 even{0.0};   // mean over all directions
    dvec3 slant{0.0};  // what a scattering in the haze sends up beyond that, per cosine
  };

  /// `sun` is the cosine of the sun with the upright.
  HazeLight(const Atmosphere& air, const SunPaths& paths, double sun, const ClearLight& clear);

  /// For cosines within kSunReach of the sun's.
  Field at(double height, double sun_cosine) const;

  /// The air that one eye sees reaches a tenth of a right angle or so around the planet: the cosine
  /// of the sun stays near its own.
  static constexpr double kSunReach = 0.2;

 private:
  double height_of(double level) const;
  std::vector<Field> column(const Atmosphere& air, const SunPaths& paths, double sun_cosine,
                            const ClearLight& clear) const;

  double sun_, first_, growth_;
  std::vector<std::vector<Field>> columns_;
};

/// By how much light in the haze follows HazeLight: 0 where haze is so thin that its own later
/// scatterings hardly matter, 1 where it hides the sky. By the optical depth straight up.
double thick_haze_share(const Atmosphere& air);

/// The share of the haze's extinction that is left if what is scattered forwards only counts as not
/// scattered.
dvec3 reduced_haze_share(const Atmosphere& air);

/// The haze's extinction times that.
dvec3 reduced_haze_extinction(const Atmosphere& air);

}  // namespace aerostat::air
