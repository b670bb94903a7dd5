#pragma once

#include "geo/place.hpp"

namespace aerostat::track {

/// Returns the distance over the ground in metres, on the ellipsoid WGS 84. The error is below a
/// thousandth for distances up to some hundred kilometres.
double distance_m(const geo::Place& a, const geo::Place& b);

/// Returns the longitude that is the same as `longitude_deg` and at most 180 degrees away from
/// `near_deg`, so that a way over 180 degrees has no jump.
double unwrapped(double longitude_deg, double near_deg);

/// Returns the longitude between -180 and 180 degrees.
double wrapped(double longitude_deg);

}  // namespace aerostat::track
