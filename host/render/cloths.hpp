#pragma once

#include <vector>

#include "asset/model.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::render {

/// Returns the textures of envelopes with pictures for world::exported_model(), as
/// pack::dyed_cloths() does, and throws its errors.
std::vector<asset::Texture> cloths_of(const scene::Scene& scene);

}  // namespace aerostat::render
