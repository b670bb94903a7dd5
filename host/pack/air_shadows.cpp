#include "pack/air_shadows.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "pack/cloud_shadows.hpp"
#include "pack/land_shadows.hpp"
#include "pack/pack_scene.hpp"
#include "rules/cumulus.h"

namespace aerostat::pack {
namespace {

/// The sine of the elevation below which clouds cast no shadows into the air.
constexpr float kLowestCloudSun = 0.02f;
/// The most points of a step through the air that are looked at for shadows, and the metres of air
/// that another point is worth if their optical depth is 1. Chosen by eye.
constexpr std::uint32_t kMostPoints = 4;
constexpr float kClearWay = 1e4f;
/// Shadows of land begin over this share of a cell. Chosen by eye.
constexpr float kLandSoftness = 0.5f;

vec3 vec_of(const aero_float (&from)[3]) {
  return {from[0], from[1], from[2]};
}

void add_land(const mesh::GridMesh& ground, std::uint64_t revision, ShadowCache& cache,
              PackedScene& packed) {
  AeroAirShadows& shadows = packed.numbers.air.shadows;
  const vec3 place = vec_of(packed.numbers.place);
  const vec3 sun = vec_of(packed.numbers.sky.sun_direction);
  const auto map = cache.land.get({revision, place, sun}, [&] {
    return std::make_shared<const ShadowMap>(land_shadows(ground, place, sun));
  });
  shadows.land = map->place;
  shadows.land.first = packed.texels.add(map, map->words);
  shadows.land_softness = kLandSoftness * map->place.cell;
  shadows.top =
      std::max(shadows.top, map->place.low + 65535.0f * map->place.unit + shadows.land_softness);
  shadows.by_land = 1;
}

/// Returns how many points of a step are looked at: the more, the more of what is seen is air.
std::uint32_t points_of(const AeroAir& air) {
  if (air.fog.extinction > 0.0f) return kMostPoints;
  const float points = std::ceil(air.haze_extinction[1] * kClearWay);
  return static_cast<std::uint32_t>(std::clamp(points, 1.0f, static_cast<float>(kMostPoints)));
}

void add_clouds(const vec3& eye, ShadowCache& cache, PackedScene& packed) {
  AeroAirShadows& shadows = packed.numbers.air.shadows;
  const AeroCumulus& clouds = packed.numbers.sky.cumulus;
  const vec3 sun = vec_of(packed.numbers.sky.sun_direction);
  const SunAxes axes(sun);
  const AeroShadowMap place = place_of_clouds(clouds, eye, axes);
  const auto map = cache.clouds.get(
      {clouds.base, clouds.thickness, clouds.size, clouds.threshold, clouds.seed, sun, place.u,
       place.v},
      [&] { return std::make_shared<const ShadowMap>(cloud_shadows(clouds, eye, sun)); });
  shadows.clouds = map->place;
  shadows.clouds.u += axes.u(clouds.drift[0], clouds.drift[1]);
  shadows.clouds.v += axes.v(clouds.drift[0], clouds.drift[1]);
  shadows.clouds.first = packed.texels.add(map, map->words);
  shadows.cloud_base = clouds.base;
  shadows.cloud_top = clouds.base + CUMULUS_TALLEST * clouds.thickness;
  shadows.cloud_slant = 1.0f / axes.rise;
  shadows.cloud_mean = map->mean;
  shadows.top = std::max(shadows.top, shadows.cloud_top);
  shadows.by_clouds = 1;
}

}  // namespace

void add_air_shadows(const mesh::GridMesh* ground, std::uint64_t revision, const vec3& eye,
                     ShadowCache& cache, PackedScene& packed) {
  const AeroSky& sky = packed.numbers.sky;
  if (sky.is_even != 0 || sky.sun_shadows == 0) return;
  const SunAxes axes(vec_of(sky.sun_direction));
  packed.numbers.air.shadows.points = points_of(packed.numbers.air);
  packed.numbers.air.shadows.sun[0] = axes.along.x;
  packed.numbers.air.shadows.sun[1] = axes.along.y;
  if (ground != nullptr && axes.level > kLeastLevel) add_land(*ground, revision, cache, packed);
  if (sky.cumulus.extinction > 0.0f && sky.sun_direction[1] > kLowestCloudSun) {
    add_clouds(eye, cache, packed);
  }
}

}  // namespace aerostat::pack
