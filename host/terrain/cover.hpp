#pragma once

#include <memory>

#include "land/cover.hpp"
#include "scene/land.hpp"
#include "terrain/relief_cache.hpp"

namespace aerostat::terrain {

/// Returns the land cover of a scene, from the cache or from its file, or null if there is none.
/// Throws the errors of land::Cover, and those of real_land().
std::shared_ptr<const land::Cover> cover_of(const scene::Terrain& terrain, ReliefCache& cache);

}  // namespace aerostat::terrain
