#include "pack/pack_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

#include "air/atmosphere.hpp"
#include "air/cloud_deck.hpp"
#include "core/copy.hpp"
#include "core/error.hpp"
#include "ground/ground_numbers.hpp"
#include "pack/cloud_chart.hpp"
#include "pack/pack_air.hpp"
#include "pack/pack_artwork.hpp"
#include "pack/pack_balloon.hpp"
#include "pack/pack_cover.hpp"
#include "pack/pack_materials.hpp"
#include "pack/sky_importance.hpp"
#include "rules/mirrors.h"
#include "scene/balloons.hpp"
#include "scene/key_light.hpp"
#include "scene/local_frame.hpp"
#include "scene/scene.hpp"
#include "terrain/cover.hpp"
#include "terrain/drape.hpp"
#include "world/special_envelope.hpp"

namespace aerostat::pack {
namespace {

/// How high the tops of heaped clouds are at most, in widths of a cloud: heaps are about as high as
/// they are wide, narrower ones would be columns. Chosen by eye.
constexpr double kTallest = 1.5;

/// Returns the value of the kernels' noise above which there is a cloud, so that clouds have the
/// given share of the sky. The values of the noise are spread about like a logistic distribution.
float cumulus_threshold(double cover) {
  if (cover >= 1.0) return -3.0f;
  const double share = std::max(cover, 1e-4);
  return static_cast<float>(0.155 * std::log((1.0 - share) / share));
}

/// Each land has other clouds, too.
std::uint32_t cumulus_seed(const scene::Scene& scene) {
  return (scene.sky.cumulus.seed + 1009u * (scene.terrain.seed - 1u)) * 2654435761u;
}

void copy_drift(aero_float* to, const dvec2& from) {
  to[0] = static_cast<float>(from.x);
  to[1] = static_cast<float>(from.y);
}

AeroCumulus pack_cumulus(const scene::Scene& scene) {
  const scene::Cumulus& from = scene.sky.cumulus;
  AeroCumulus cumulus{};
  cumulus.base = static_cast<float>(from.base_m);
  cumulus.thickness = static_cast<float>(std::min(from.thickness_m, kTallest * from.size_m));
  cumulus.size = static_cast<float>(from.size_m);
  cumulus.threshold = cumulus_threshold(from.cover);
  cumulus.extinction = from.cover > 0.0 ? static_cast<float>(air::kCloudExtinction) : 0.0f;
  cumulus.seed = cumulus_seed(scene);
  copy_drift(cumulus.drift, from.drift_m);
  cumulus.rise = static_cast<float>(from.rise_m);
  return cumulus;
}

AeroSky pack_sky(const scene::Scene& scene) {
  AeroSky sky{};
  scene::KeyLight key = scene::key_light(scene);
  // Under an even sky it is never night.
  if (scene.sky.radiance) {
    key = {glm::normalize(scene.sun.direction), dvec3(scene.sun.color) * scene.sun.irradiance};
  }
  copy(sky.sun_direction, key.direction);
  copy(sky.sun_irradiance, key.irradiance);
  sky.moonlit = key.is_moon ? 1u : 0u;
  const double radius = 0.5 * glm::radians(scene.sun.diameter_deg);
  sky.sun_chord = static_cast<float>(2.0 * std::sin(0.5 * radius));
  sky.cloud_cover = static_cast<float>(scene.sky.cloud_cover);
  sky.cloud_height = static_cast<float>(scene.sky.cloud_height_m);
  copy_drift(sky.cloud_drift, scene.sky.cloud_drift_m);
  sky.cloud_bend = static_cast<float>(scene.sky.cloud_bend_m);
  sky.sun_shadows = scene.sun.shadows ? 1u : 0u;
  sky.sun_spread = scene.sun.soft_shadows ? static_cast<float>(std::tan(radius)) : 0.0f;
  sky.ambient_reach =
      scene.sky.ambient_occlusion ? static_cast<float>(scene.sky.occlusion_m) : 0.0f;
  sky.bounced = scene.sky.bounced_light ? 1u : 0u;
  if (scene.sky.radiance) {
    sky.is_even = 1u;
    sky.cloud_cover = 0.0f;
    return sky;
  }
  sky.cumulus = pack_cumulus(scene);
  return sky;
}

AeroWater pack_water(const scene::Water& from) {
  AeroWater water{};
  copy(water.absorption, from.absorption_per_m);
  copy(water.scatter, from.scatter);
  copy(water.bed, from.bed);
  // Without a sea nothing is wet.
  water.level = from.enabled ? static_cast<float>(from.level_m) : -1e9f;
  water.wave = static_cast<float>(std::max(from.wave_m, ground::kShortestWaveM));
  water.wave_slope = static_cast<float>(from.wave_slope);
  water.time = static_cast<float>(from.time_s);
  return water;
}

AeroPointLight pack_light(const scene::PointLight& from, const dvec3& origin) {
  AeroPointLight light{};
  copy(light.position, from.position - origin);
  copy(light.intensity, dvec3(from.color) * from.intensity);
  light.shadows = from.shadows ? 1u : 0u;
  return light;
}

/// Packs all balloons that are there, in the order of scene::balloons_of(), and the pictures on
/// them.
void pack_balloons(const scene::ResolvedScene& scene, ArtworkCache& cache,
                   world::ModelCache& models, PackedScene& packed) {
  AeroScene& numbers = packed.numbers;
  const auto balloons = scene::balloons_of(*scene);
  if (balloons.size() > AERO_MAX_BALLOONS) {
    throw Error(ErrorKind::bad_data,
                fmt::format("/balloons: found {} balloons with the first one, expected at most {}",
                            balloons.size(), AERO_MAX_BALLOONS));
  }
  std::vector<PackedArtwork> artwork = pack_artwork(*scene, cache, packed.texels);
  for (std::size_t i = 0; i < balloons.size(); ++i) {
    if (!balloons[i]->envelope) continue;
    artwork[i].mean_cloth = world::mean_color(*models.models_of(*scene)->envelopes[i]);
  }
  for (std::size_t i = 0; i < balloons.size(); ++i) {
    numbers.balloons[i] = pack_balloon(scene, *balloons[i], artwork[i]);
    numbers.any_artwork = std::max(numbers.any_artwork, artwork[i].place);
  }
  numbers.balloon_count = static_cast<std::uint32_t>(balloons.size());
}

/// Returns a material of one colour that reflects light evenly.
AeroMaterial plain_model(const AeroMaterial& from) {
  AeroMaterial material = from;
  material.kind = AERO_MATERIAL_PLAIN;
  material.specular = material.translucency = 0.0f;
  std::fill(std::begin(material.emission), std::end(material.emission), 0.0f);
  material.see_through = AERO_OPAQUE;
  return material;
}

/// Returns whether rays look for what water and models from files mirror.
bool looks_into_mirrors(const scene::Scene& scene, bool has_models) {
  if (scene.surfaces != scene::Surfaces::full || scene.light != scene::Integrator::local) {
    return false;
  }
  const scene::Water& water = scene.biome.water;
  return (water.enabled && water.wave_slope <= MIRRORING_SLOPE) || has_models;
}

/// Appends the materials of the scene's models and their textures.
void pack_models(const scene::Scene& scene, world::ModelCache& models, PackedModelCache& cache,
                 PackedScene& packed) {
  const auto placed = models.models_of(scene);
  if (placed->models.empty()) return;
  const auto found = cache.get(placed, [&] { return pack::pack_models(*placed); });
  AeroScene& numbers = packed.numbers;
  const std::uint32_t first = packed.texels.add(found, found->texels);
  numbers.white_texture = first;
  for (std::size_t i = 0; i < found->materials.size(); ++i) {
    AeroMaterial material = found->materials[i];
    for (aero_uint* texture : {&material.color_texture, &material.metal_texture,
                               &material.normal_texture, &material.emission_texture}) {
      *texture += first;
    }
    if (scene.surfaces == scene::Surfaces::plain) material = plain_model(material);
    packed.see_through |= material.see_through != AERO_OPAQUE;
    numbers.materials[AERO_FIXED_MATERIALS + i] = material;
  }
}

std::uint32_t shading_of(scene::Shading shading) {
  switch (shading) {
    case scene::Shading::flat:
      return AERO_SHADING_FLAT;
    case scene::Shading::gouraud:
      return AERO_SHADING_GOURAUD;
    case scene::Shading::phong:
      return AERO_SHADING_PHONG;
  }
  return AERO_SHADING_PHONG;
}

}  // namespace

AeroDrape pack_drape(const land::Drape& from, double blend, std::uint32_t first) {
  AeroDrape drape{};
  drape.middle[0] = static_cast<float>(from.middle().x);
  drape.middle[1] = static_cast<float>(from.middle().y);
  drape.texel = static_cast<float>(from.texel_m());
  drape.side = static_cast<std::uint32_t>(from.side());
  drape.levels = static_cast<std::uint32_t>(from.levels());
  drape.blend = static_cast<float>(blend);
  drape.first = first;
  return drape;
}

PackedScene pack_scene(const scene::ResolvedScene& scene) {
  PackCache cache;
  terrain::ReliefCache reliefs;
  world::ModelCache models;
  return pack_scene(scene, cache, reliefs, models);
}

PackedScene pack_scene(const scene::ResolvedScene& scene, PackCache& cache,
                       terrain::ReliefCache& reliefs, world::ModelCache& models) {
  if (scene->lights.size() > AERO_MAX_POINT_LIGHTS) {
    throw Error(ErrorKind::bad_data, fmt::format("/lights: found {} lights, expected at most {}",
                                                 scene->lights.size(), AERO_MAX_POINT_LIGHTS));
  }
  PackedScene packed;
  AeroScene& numbers = packed.numbers;
  numbers.sky = pack_sky(*scene);
  const vec3 eye(scene::place_of(*scene, scene.eye()));
  packed.cloud_chart = cloud_chart(numbers.sky.cumulus, eye, cache.clouds);
  if (packed.cloud_chart) {
    AeroCloudChart& chart = numbers.sky.cumulus.chart;
    chart = packed.cloud_chart->place;
    chart.x0 += numbers.sky.cumulus.drift[0];
    chart.z0 += numbers.sky.cumulus.drift[1];
  }
  numbers.ground = ground::ground_numbers(*scene);
  numbers.water = pack_water(scene->biome.water);
  pack_balloons(scene, cache.artwork, models, packed);
  pack_materials(*scene, numbers.materials);
  for (std::size_t i = 0; i < scene->lights.size(); ++i) {
    numbers.lights[i] = pack_light(scene->lights[i], scene.origin());
  }
  numbers.light_count = static_cast<std::uint32_t>(scene->lights.size());
  numbers.shading = shading_of(scene->shading);
  numbers.bounces = static_cast<std::uint32_t>(scene->bounces);
  PackedAir air = pack_air(scene, cache.air);
  numbers.air = air.numbers;
  numbers.night = air.night;
  packed.sky_table = std::move(air.sky_table);
  if (scene->light == scene::Integrator::path) {
    packed.sky_importance = sky_importance(numbers, packed.sky_table);
  }
  copy(numbers.place, scene::place_of(*scene, scene.origin()));
  if (const auto drape = terrain::drape_of(scene->terrain, reliefs)) {
    const std::uint32_t first = packed.texels.add(drape, drape->texels());
    numbers.drape = pack_drape(*drape, scene->terrain.drape.blend, first);
  }
  if (const auto cover = terrain::cover_of(scene->terrain, reliefs)) {
    const std::uint32_t first = packed.texels.add(cover, cover->ground().texels);
    numbers.cover = pack_cover(*scene, *cover, first);
  }
  pack_models(*scene, models, cache.models, packed);
  packed.mirrors = looks_into_mirrors(
      *scene, numbers.materials[AERO_FIXED_MATERIALS].kind == AERO_MATERIAL_MODEL);
  return packed;
}

}  // namespace aerostat::pack
