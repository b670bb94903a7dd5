#pragma once

#include <array>
#include <vector>

#include "air/light.hpp"
#include "scene/resolved_scene.hpp"
#include "scene_params.h"

namespace aerostat::pack {

/// Packs moon and stars. `sky_table` has the sky of the key light. The table of an afterglow and
/// the stars are put behind it.
AeroNight pack_night(const scene::ResolvedScene& scene, const air::Light& light,
                     std::vector<AeroSkyCell>& sky_table);

/// Returns the rows of the matrix that turns directions of a scene into the frame of the equator of
/// 2000, for a local sidereal time and latitude in degrees and a year of precession.
std::array<dvec3, 3> equator_rows(double sidereal_deg, double latitude_deg, double year);

}  // namespace aerostat::pack
