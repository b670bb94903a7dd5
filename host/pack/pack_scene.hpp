#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "air/light.hpp"
#include "bvh/bvh.hpp"
#include "camera.h"
#include "land/drape.hpp"
#include "pack/air_shadows.hpp"
#include "pack/cloud_chart.hpp"
#include "pack/pack_artwork.hpp"
#include "pack/pack_models.hpp"
#include "pack/texels.hpp"
#include "scene/resolved_scene.hpp"
#include "scene_params.h"
#include "terrain/relief_cache.hpp"
#include "world/scene_models.hpp"

namespace aerostat::pack {

/// A scene for the device: its numbers (light, air, materials and ground rules) and its tables.
struct PackedScene {
  AeroScene numbers{};
  /// AERO_SKY_CELLS cells, as many more with an afterglow, and what AeroStars finds behind them.
  std::vector<AeroSkyCell> sky_table;
  /// The chart of clouds, or null if there is none.
  std::shared_ptr<const CloudChart> cloud_chart;
  /// The texels of all pictures.
  Texels texels = {};
  /// Whether there are surfaces that let some rays pass.
  bool see_through = false;
  /// Whether rays look for what still water and models from files mirror.
  bool mirrors = false;
  /// The probabilities by which paths look for light in the sky, if light goes along paths.
  std::optional<AeroSkyImportance> sky_importance = {};
};

/// Packs a scene. Throws Error{bad_data} for more than AERO_MAX_POINT_LIGHTS point lights or
/// AERO_MAX_BALLOONS balloons.
PackedScene pack_scene(const scene::ResolvedScene& scene);

/// What packing a scene keeps for the next one.
struct PackCache {
  air::ScatteringCache air;
  CloudChartCache clouds;
  ShadowCache shadows;
  PackedModelCache models;
  ArtworkCache artwork;
};

/// Packs a scene with what caches have of the air, the clouds, the picture on the ground and the
/// models, and leaves its own there. Shadows in the air need the built ground, and
/// add_air_shadows() adds them. Throws the errors of ModelCache::models_of(), pack_models()
/// and pack_artwork(), too.
PackedScene pack_scene(const scene::ResolvedScene& scene, PackCache& cache,
                       terrain::ReliefCache& reliefs, world::ModelCache& models);

/// Packs a picture on the ground, whose texels begin at `first` in the buffer of texels.
AeroDrape pack_drape(const land::Drape& drape, double blend, std::uint32_t first = 0);

/// Camera, image size and sampling. Parallel rays begin shortly before `world`, the bounds of all
/// that they can meet, if the eye is far away from it: single precision would bend them.
AeroFrame pack_frame(const scene::ResolvedScene& scene, const bvh::Bounds& world = {});

}  // namespace aerostat::pack
