#pragma once

#include <array>

#include "scene/scene.hpp"

namespace aerostat::scene::detail {

/// Returns the Phong coefficients of all objects in a scene of that biome.
std::array<Material, kObjectCount> default_materials(BiomeKind biome);

}  // namespace aerostat::scene::detail
