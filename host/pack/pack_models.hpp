#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/last_made.hpp"
#include "material.h"
#include "world/scene_models.hpp"

namespace aerostat::pack {

/// The materials of all models of a scene, and their textures.
struct PackedModels {
  /// In the order of SceneModels. The places of their textures count from the first word of
  /// `texels`.
  std::vector<AeroMaterial> materials;
  /// The textures one behind the other. The first one is white.
  std::vector<std::uint32_t> texels;
};

/// The most words that the textures of a scene's models may take together, with all their levels:
/// 1 GiB.
inline constexpr std::size_t kMostTextureWords = std::size_t{1} << 28;

/// Packs the materials of models. Runs on all cores. Throws Error{exhausted} if the textures take
/// more than kMostTextureWords.
std::shared_ptr<const PackedModels> pack_models(const world::SceneModels& models);

/// The models that were packed last, by the models of the scene.
using PackedModelCache = LastMade<std::shared_ptr<const world::SceneModels>, PackedModels>;

}  // namespace aerostat::pack
