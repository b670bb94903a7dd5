#pragma once

#include "core/math.hpp"

namespace aerostat::scene::detail {

/// The two angles of a direction towards the sky, as aerostat::direction_from_angles takes them.
struct SunAngles {
  double azimuth_deg = 0.0;
  double elevation_deg = 0.0;
};

/// Returns the angles of a direction of any length. The vector (0, 0, 0) gives angles of 0.
SunAngles angles_of(const dvec3& direction);

/// Returns the unit vector of these angles.
dvec3 direction_of(const SunAngles& angles);

}  // namespace aerostat::scene::detail
