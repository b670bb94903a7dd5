#pragma once

#include <cstdint>

#include "core/last_made.hpp"
#include "core/math.hpp"
#include "mesh/grid_mesh.hpp"
#include "pack/shadow_map.hpp"

namespace aerostat::pack {

struct PackedScene;

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
