#pragma once

#include <cstdint>

#include "land/cover.hpp"
#include "scene_params.h"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::pack {

/// Packs the land cover of a scene, whose texels begin at `first` in the buffer of texels, with the
/// colours that its classes have in the scene's biome.
AeroCover pack_cover(const scene::Scene& scene, const land::Cover& cover, std::uint32_t first);

}  // namespace aerostat::pack
