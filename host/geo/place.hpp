#pragma once

namespace aerostat::geo {

/// A place on the Earth in degrees, on the datum WGS 84. North and east are positive.
struct Place {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;

  bool operator==(const Place&) const = default;
};

/// The mean radius of the Earth in metres (IUGG).
inline constexpr double kEarthRadius_m = 6371008.8;

/// The share by which refraction in mean air bends rays of light after the ground, relative to the
/// curvature of the Earth. Surveyors use this value.
inline constexpr double kRefraction = 0.13;

}  // namespace aerostat::geo
