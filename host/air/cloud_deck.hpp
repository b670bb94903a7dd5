#pragma once

#include "core/math.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::air {

/// Extinction of heaped clouds per metre: some 125 droplets of 8 um radius a cubic centimetre.
inline constexpr double kCloudExtinction = 0.05;

/// Heaped clouds as a level layer that hides a share of the sky, for the light that they leave to
/// the land below and send back to the air above.
struct CloudDeck {
  double cover = 0.0;  // share of the sky straight above, 0 to 1
  double depth = 0.0;  // mean optical depth of a cloud straight up
  double base = 0.0, top = 0.0;

  /// Returns the share of diffuse and of direct light that comes down through a cloud. It is the
  /// two-stream solution for droplets that absorb nothing:
  ///   1 / (1 + 3/4 (1 - g) depth)
  double transmittance() const;

  /// Returns the mean share of sunlight that still comes from the sun below the clouds.
  /// `sun_cosine` is the cosine of the sun with the upright.
  double sun_below(double sun_cosine) const;

  /// Returns the share of the sky that the clouds hide in a direction whose cosine with the
  /// upright is given. Low parts of the sky are hidden by the sides of clouds, too.
  double hidden(double cosine) const;

  /// Returns the irradiance of level ground below the clouds as a share of that without clouds.
  /// Light goes to and fro between clouds and ground.
  dvec3 light_below(const dvec3& ground_albedo) const;
};

/// Returns the clouds of a scene as a layer.
CloudDeck cloud_deck_of(const scene::Scene& scene);

}  // namespace aerostat::air
