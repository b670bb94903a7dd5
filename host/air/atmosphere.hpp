#pragma once

#include "core/math.hpp"
#include "scene/scene.hpp"

/// The air around the planet: what it is made of at each height, and how that scatters light.
/// Heights in metres above the sea, lengths in metres, colours linear Rec. 709.
namespace aerostat::air {

inline constexpr double kGroundRadius = 6360e3;
inline constexpr double kTopHeight = 100e3;  // above it there is nothing
inline constexpr double kSunRadius = 0.5 * 0.53 * (std::numbers::pi / 180.0);  // of its disc, rad

/// Rayleigh's optical depth of the whole air straight up, by the wavelength in micrometres: 0.0971
/// at 0.55. Source: B. A. Bodhaine et al., "On Rayleigh Optical Depth Calculations", J. Atmos.
/// Oceanic Technol. 16 (1999), equation 30.
double rayleigh_depth(double wavelength_um);

/// The wavelengths that stand for red, green and blue. Averaged over the sun's spectrum (5800 K)
/// and the colour matching functions, exp(-m rayleigh_depth) in linear Rec. 709 follows these three
/// within 3 % for one to ten airs m.
inline constexpr dvec3 kWavelengths_um{0.645, 0.550, 0.442};

/// How dense each part of the air is, relative to what its coefficients speak of.
struct Density {
  double molecules = 0.0;
  double haze = 0.0;
  double ozone = 0.0;
  double fog = 0.0;
};

/// Fills valleys up to `top`, thins out above it over `softness`.
struct FogLayer {
  double extinction = 0.0;  // per metre deep inside, 0 = no fog
  double top = 0.0;
  double softness = 1.0;

  bool operator==(const FogLayer&) const = default;
};

/// Coefficients per metre: molecules and haze at the sea, ozone at its thickest, 25 km up.
struct Atmosphere {
  dvec3 molecules{0.0};        // scattering = extinction
  dvec3 haze_scattering{0.0};  // by droplets and dust
  dvec3 haze_extinction{0.0};
  dvec3 ozone{0.0};  // absorption
  double molecules_height = 8400.0;
  double haze_height = 1200.0;
  double haze_asymmetry = 0.76;
  FogLayer fog;
  dvec3 ground_albedo{0.2};

  /// At a height; below the sea as at the sea.
  Density density(double height) const;
  /// The mean over heights that go evenly from one to the other: exact for molecules, haze and fog.
  Density mean_density(double from, double to) const;
  dvec3 extinction(const Density& density) const;
  dvec3 scattering(const Density& density) const;

  bool operator==(const Atmosphere&) const = default;
};

/// The haze's extinction at green and that of the molecules make 3.912 / visibility (H.
/// Koschmieder, 1924: contrast falls to 2 %); where the molecules alone are more, there is no haze.
Atmosphere atmosphere_of(const scene::Scene& scene);

/// Share of scattered light per steradian by the cosine of the angle of deflection: Rayleigh's, of
/// molecules.
double rayleigh_phase(double cosine);

/// Of droplets, `asymmetry` -1 to 1 being the mean cosine nearly. Source: W. M. Cornette and J. G.
/// Shanks, "Physically reasonable analytic expression for the single-scattering phase function",
/// Applied Optics 31 (1992).
double haze_phase(double cosine, double asymmetry);

/// Metres from a height along a direction, whose cosine with the upright is given, to the sphere of
/// another height; infinite where it is not met. From outside the nearer point, from inside the
/// only one.
double distance_to_height(double from, double cosine, double to);

/// Height after a way of `distance`.
double height_after(double from, double cosine, double distance);

}  // namespace aerostat::air
