#pragma once

#include <array>

#include "scene/land.hpp"
#include "scene/objects.hpp"

namespace aerostat::scene::detail {

/// Returns the table of materials of a scene of that biome.
std::array<Material, kMaterialCount> default_materials(BiomeKind biome);

}  // namespace aerostat::scene::detail
