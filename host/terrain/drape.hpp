#pragma once

#include <memory>

#include "land/drape.hpp"
#include "scene/land.hpp"
#include "terrain/relief_cache.hpp"

namespace aerostat::terrain {

/// Returns the picture on the ground of a scene, from the cache or from its file, or null if there
/// is none. Throws the errors of land::Drape, and those of real_land().
std::shared_ptr<const land::Drape> drape_of(const scene::Terrain& terrain, ReliefCache& cache);

}  // namespace aerostat::terrain
