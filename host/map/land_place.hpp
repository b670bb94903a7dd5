#pragma once

#include <string>

#include "geo/place.hpp"
#include "world/surface.hpp"

namespace aerostat::map {

/// Returns the terrain of a scene. Throws Error{bad_data}, with the option that needs it, if the
/// ground does not come from a file.
const scene::Terrain& require_real_land(const scene::Scene& scene, const std::string& option);

/// Returns the place on the Earth of the terrain's centre. Throws Error{bad_data}, with the option
/// that needs it, if the ground does not come from a file, or if it is unknown where the file lies.
geo::Place land_place(const scene::Scene& scene, world::ReliefCache& reliefs,
                      const std::string& option);

}  // namespace aerostat::map
