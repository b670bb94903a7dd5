#pragma once

#include <vector>

#include "asset/model.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::pack {

/// The size of the texture of a dyed cloth. A texel of a usual envelope is 15 mm wide at its widest
/// place.
inline constexpr std::uint32_t kClothWidth = 4096, kClothHeight = 2048;

/// Returns a texture for each of scene::balloons_of() that has pictures on a usual envelope, and
/// one of no size for the others. It holds the colours of the fabric with the pictures over them,
/// without the material's albedo, so that other programs can show them: u goes once around the
/// gores, and v from the rim of the crown's plate, which is the first row, down to the mouth in
/// equal steps for each panel, of which the parachute disc is one. Throws what
/// ArtworkCache::picture() throws, with the JSON pointer of the picture in front.
std::vector<asset::Texture> dyed_cloths(const scene::Scene& scene);

}  // namespace aerostat::pack
