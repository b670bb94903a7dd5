#pragma once

#include "scene/celestial.hpp"

namespace aerostat::scene::detail {

/// The moon as seen from the middle of the Earth.
struct MoonPlace {
  Equatorial place;
  double distance_km = 0.0;
};

/// Returns the apparent place of the moon, right to 0.01 degrees and 50 km for the years 1900 to
/// 2100. Source: J. Meeus, "Astronomical Algorithms" (2nd ed., 1998), chapter 47, of whose terms
/// those below 0.002 degrees are left out.
MoonPlace moon_place_at(double days_from_2000);

/// The moon as seen from a place on the ground.
struct MoonSeen {
  SunAngles angles;
  double distance_km = 0.0;
};

/// Returns the position of the moon, lifted by refraction in mean air. The observer stands on a
/// round Earth at sea level, so that the parallax, which is up to 1 degree, is right to 0.01
/// degrees.
MoonSeen moon_seen_at(double days_from_2000, double latitude_deg, double longitude_deg);

}  // namespace aerostat::scene::detail
