#pragma once

#include "core/math.hpp"

namespace aerostat::scene::detail {

/// The two angles of a direction towards the sky, as aerostat::direction_from_angles reads them.
struct SunAngles {
  double azimuth_deg = 0.0;
  double elevation_deg = 0.0;
};

/// `direction` may have any length; (0, 0, 0) gives angles of 0.
SunAngles angles_of(const dvec3& direction);

/// A unit vector.
dvec3 direction_of(const SunAngles& angles);

}  // namespace aerostat::scene::detail
