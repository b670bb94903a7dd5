#pragma once

/// The shape of the Earth.
namespace aerostat {

/// The mean radius of the Earth in metres (IUGG).
inline constexpr double kEarthRadius_m = 6371008.8;

/// The share by which refraction in mean air bends rays of light after the ground, relative to the
/// curvature of the Earth. Surveyors use this value.
inline constexpr double kRefraction = 0.13;

/// The ground seems to fall by this number times the square of the distance in metres below the
/// plane that touches the Earth.
inline constexpr double kEarthFall_per_m = (1.0 - kRefraction) / (2.0 * kEarthRadius_m);

}  // namespace aerostat
