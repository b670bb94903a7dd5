#pragma once

#include "core/math.hpp"

namespace aerostat::scene {
struct Scene;
}

/// These types and functions describe the air around the planet: its composition at each height
/// and the way it scatters light. Heights are in metres above the sea, lengths in metres, and
/// colours in linear Rec. 709.
namespace aerostat::air {

inline constexpr double kGroundRadius = 6360e3;
inline constexpr double kTopHeight = 100e3;  // there is no air above this height
inline constexpr double kSunRadius = 0.5 * 0.53 * (std::numbers::pi / 180.0);  // angular, in rad

/// Returns Rayleigh's optical depth of the whole air straight up. The wavelength is in
/// micrometres, and the depth at 0.55 is 0.0971. Source: B. A. Bodhaine et al., "On Rayleigh
/// Optical Depth Calculations", J. Atmos. Oceanic Technol. 16 (1999), equation 30.
double rayleigh_depth(double wavelength_um);

/// The wavelengths that stand for red, green and blue, in micrometres. The transmittance exp(-m
/// rayleigh_depth) at these three follows the one in linear Rec. 709, averaged over the sun's
/// spectrum (5800 K) and the colour matching functions, within 3 % for air masses m from one to
/// ten.
inline constexpr dvec3 kWavelengths_um{0.645, 0.550, 0.442};

/// The density of each part of the air, relative to the density for which its coefficients hold.
struct Density {
  double molecules = 0.0;
  double haze = 0.0;
  double ozone = 0.0;
  double fog = 0.0;
};

/// A layer of fog that fills valleys up to `top` and thins out above it over `softness`.
struct FogLayer {
  double extinction = 0.0;  // per metre, deep inside; 0 = no fog
  double top = 0.0;
  double softness = 1.0;

  bool operator==(const FogLayer&) const = default;
};

/// Coefficients per metre. Those of molecules and haze hold at the sea, that of ozone where it is
/// densest, 25 km up.
struct Atmosphere {
  dvec3 molecules{0.0};        // scattering, which is equal to extinction
  dvec3 haze_scattering{0.0};  // scattering by droplets and dust
  dvec3 haze_extinction{0.0};
  dvec3 ozone{0.0};  // absorption
  double molecules_height = 8400.0;
  double haze_height = 1200.0;
  double haze_asymmetry = 0.76;
  FogLayer fog;
  dvec3 ground_albedo{0.2};

  /// Returns the densities at a height. Below the sea, they are those at the sea.
  Density density(double height) const;
  /// Returns the mean densities over heights that change evenly from one to the other. They are
  /// exact for molecules, haze and fog.
  Density mean_density(double from, double to) const;
  dvec3 extinction(const Density& density) const;
  dvec3 scattering(const Density& density) const;

  bool operator==(const Atmosphere&) const = default;
};

/// Returns the air of a scene. At green, haze and molecules have an extinction of 3.912 /
/// visibility, so that contrast falls to 2 % (H. Koschmieder, 1924). There is no haze where the
/// extinction of the molecules alone is larger.
Atmosphere atmosphere_of(const scene::Scene& scene);

/// Returns the phase function of molecules (Rayleigh): the share of scattered light per
/// steradian, by the cosine of the angle of deflection.
double rayleigh_phase(double cosine);

/// Returns the phase function of droplets, per steradian. `asymmetry`, -1 to 1, is nearly the
/// mean cosine. Source: W. M. Cornette and J. G. Shanks, "Physically reasonable analytic
/// expression for the single-scattering phase function", Applied Optics 31 (1992).
double haze_phase(double cosine, double asymmetry);

/// Returns the metres from one height along a direction to the sphere of another height, or
/// infinity if the sphere is not met. `cosine` is the cosine of the direction with the upright.
/// From outside, the nearer of two points counts. From inside, there is only one.
double distance_to_height(double from, double cosine, double to);

/// Returns the height after a path of `distance`, which starts at the height `from` in the
/// direction of `cosine`.
double height_after(double from, double cosine, double distance);

}  // namespace aerostat::air
