#pragma once

#include <memory>

#include "core/last_made.hpp"
#include "land/land.hpp"
#include "scene/land.hpp"

namespace aerostat::terrain {

/// Keeps the files of real land that were read last.
using RealLandCache = LastMade<land::LandOptions, land::Land>;

/// Returns what a scene asks of files.
land::LandOptions land_options(const scene::ElevationSource& source);

/// Returns the land of a scene's files, from the cache or from the files.
std::shared_ptr<const land::Land> real_land(const scene::ElevationSource& source,
                                            RealLandCache& lands);

/// Returns the point of the land that lies at the terrain's centre. Throws Error{bad_data} if the
/// scene gives a latitude and longitude for files whose place on the Earth is unknown.
land::LandPoint middle_point(const scene::ElevationSource& source, const land::Land& land);

}  // namespace aerostat::terrain
