#pragma once

#include <cstdint>
#include <vector>

#include "core/last_made.hpp"
#include "core/math.hpp"
#include "mesh/grid_mesh.hpp"
#include "scene_params.h"

namespace aerostat::pack {

struct PackedScene;

/// A map of shadows: its place, and its words for the buffer of texels.
struct ShadowMap {
  AeroShadowMap place{};
  std::vector<std::uint32_t> words;
  /// The mean of the nodes of clouds.
  float mean = 1.0f;
};

/// Returns the heights in metres above the sea below which the ground hides the middle of the sun.
/// `ground` counts from a point that lies at `place` over the terrain. `sun` is the unit vector to
/// the sun, which is not straight above. For each row of nodes along the sun's azimuth there is one
/// sweep over the heights h at intervals d, from the sun's side on:
///   H[i] = max(h[i], H[i + 1] - d tan(elevation))
/// Beyond the ground, h is lower than any ground.
ShadowMap land_shadows(const mesh::GridMesh& ground, const vec3& place, const vec3& sun);

/// Returns the shares of sunlight that heaped clouds leave at their bases, around the point at
/// which a ray from the eye to the sun passes them. They are those of cumulus_shadow() on the
/// device without the clouds' bulges. Nodes lie the same whatever the eye. `sun` is above the
/// horizon.
ShadowMap cloud_shadows(const AeroCumulus& clouds, const vec3& eye, const vec3& sun);

/// What the maps of shadows of land and of clouds are made of.
struct LandShadowKey {
  std::uint64_t ground = 0;
  vec3 place{0.0f}, sun{0.0f};

  bool operator==(const LandShadowKey&) const = default;
};
struct CloudShadowKey {
  float base, thickness, size, threshold;
  std::uint32_t seed;
  vec3 sun{0.0f};
  float u, v;

  bool operator==(const CloudShadowKey&) const = default;
};

/// Keeps the maps of the last scene.
struct ShadowCache {
  LastMade<LandShadowKey, ShadowMap> land;
  LastMade<CloudShadowKey, ShadowMap> clouds;
};

/// Adds the maps of shadows in the air to a packed scene: those of `ground`, which may be null and
/// whose revision tells grounds apart, and those of heaped clouds. `eye` counts from the place of
/// the terrain.
void add_air_shadows(const mesh::GridMesh* ground, std::uint64_t revision, const vec3& eye,
                     ShadowCache& cache, PackedScene& packed);

}  // namespace aerostat::pack
