#pragma once

#include <functional>
#include <vector>

#include "air/sun_paths.hpp"

namespace aerostat::air {

/// The light inside haze that is too thick for light to leave it after a few scatterings. It
/// diffuses in level layers (Eddington's approximation), which keeps all light that is not
/// absorbed. Haze deflects light so little that its scattering counts as (1 - asymmetry) of an
/// even one (the similarity relation). Light that was only scattered forwards still counts as
/// sunlight. Source: H. C. van de Hulst, "Multiple Light Scattering" (1980), chapter 14. All
/// light is per irradiance of the sun outside the air.
class HazeLight {
 public:
  /// Returns the light of the air without haze, mean over all directions, by height and cosine of
  /// the sun.
  using ClearLight = std::function<dvec3(double, double)>;

  struct Field {
    dvec3 even{0.0};   // mean over all directions
    dvec3 slant{0.0};  // light that a scattering sends up beyond the mean, per cosine
  };

  /// Computes the light for a sun whose cosine with the upright is `sun`.
  HazeLight(const Atmosphere& air, const SunPaths& paths, double sun, const ClearLight& clear);

  /// Returns the light at a height. `sun_cosine` must be within kSunReach of the sun's cosine.
  Field at(double height, double sun_cosine) const;

  /// The reach of the table around the cosine of the sun. The air that one eye sees extends about
  /// a tenth of a right angle around the planet, so that the cosine changes little within it.
  static constexpr double kSunReach = 0.2;

 private:
  double height_of(double level) const;
  std::vector<Field> column(const Atmosphere& air, const SunPaths& paths, double sun_cosine,
                            const ClearLight& clear) const;

  double sun_, first_, growth_;
  std::vector<std::vector<Field>> columns_;
};

/// Returns the share, 0 to 1, of the light in the haze that follows HazeLight. It depends on the
/// optical depth straight up. It is 0 if haze is so thin that its later scatterings hardly
/// matter, and 1 if haze hides the sky.
double thick_haze_share(const Atmosphere& air);

/// Returns the share of the haze's extinction that is left if light that is only scattered
/// forwards counts as not scattered.
dvec3 reduced_haze_share(const Atmosphere& air);

/// Returns the haze's extinction times reduced_haze_share.
dvec3 reduced_haze_extinction(const Atmosphere& air);

}  // namespace aerostat::air
