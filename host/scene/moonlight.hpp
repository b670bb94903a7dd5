#pragma once

#include "core/math.hpp"

/// The moon as a lit ball. Its phase follows from where the moon and the sun stand.
namespace aerostat::scene {

struct Moon;

inline constexpr double kMeanMoonDistanceKm = 384400.0;
inline constexpr double kMoonRadiusKm = 1737.4;

struct MoonPhase {
  dvec3 to_sun{0.0};       // unit vector from the moon to the sun
  double phase_rad = 0.0;  // angle between sun and Earth, as seen from the moon; 0 = full moon
  double lit_share = 1.0;  // share of the disc that is lit
};

/// Returns the phase of a moon in this direction under a sun in that one, both unit vectors.
/// Source: J. Meeus, "Astronomical Algorithms" (2nd ed., 1998), chapter 48.
MoonPhase moon_phase(const dvec3& moon, double distance_km, const dvec3& sun);

/// Returns the visual magnitude of the moon. Source: C. W. Allen, "Astrophysical Quantities"
/// (3rd ed., 1973), section 66, for the mean distance. The last formula holds up to 150 degrees
/// or so; thinner crescents are taken to be dimmer by the share of the disc that is lit.
double moon_magnitude(double phase_rad, double distance_km);

/// Returns the irradiance by the moon outside the air as a share of the sun's. The moon is a
/// little redder than the sun: its B-V is 0.92 and the sun's 0.65.
dvec3 moon_share_of_sun(double phase_rad, double distance_km);

/// Returns the unit vector towards the moon.
dvec3 moon_direction(const Moon& moon);

}  // namespace aerostat::scene
