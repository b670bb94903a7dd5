#include "scatter/biome_layers.hpp"

#include <algorithm>
#include <cmath>

#include "core/smooth_step.hpp"
#include "scene/scene.hpp"

namespace aerostat::scatter {

namespace {

// The albedo of the boulder models. Dividing by it lets the tint turn their colour into that of the
// ground.
const vec3 kBoulderAlbedo{0.19f, 0.183f, 0.175f};

/// Returns the probability of a boulder at a site. Boulders come in heaps and are more frequent
/// towards bare rock and shores, and rare deep in the woods.
float boulder_chance(const ground::GroundRule& rule, const Site& site, float heaps) {
  const ground::GroundMix mix = rule.mix(site.position, site.normal.y, site.noise);
  const float heap = smooth_step(0.25f, 0.9f, site.noise.fine - 0.4f * site.noise.broad);
  const float shore =
      smooth_step(4.0f, 1.5f, site.above_sea) * smooth_step(0.1f, 0.7f, -site.noise.broad);
  const float likely = heaps * heap + 0.35f * mix.rock + 0.3f * shore;
  return likely * (1.0f - 0.9f * mix.forest);
}

}  // namespace

std::vector<Layer> biome_layers(const Nature& nature) {
  switch (nature.scene.biome.kind) {
    case scene::BiomeKind::tropical:
      return tropical_layers(nature);
    case scene::BiomeKind::sand:
      return sand_layers(nature);
    case scene::BiomeKind::meadow:
      return meadow_layers(nature);
    case scene::BiomeKind::snow:
      break;
  }
  return snow_layers(nature);
}

float sea_level(const Nature& nature) {
  const scene::Water& water = nature.scene.biome.water;
  return water.enabled ? static_cast<float>(water.level_m) : -1e6f;
}

double spacing_of(const Nature& nature, double spacing_m) {
  return spacing_m / std::sqrt(nature.scene.vegetation.density);
}

double reach_of(const Nature& nature, double reach_m) {
  return nature.scene.vegetation.reach_m * (reach_m / 6000.0);
}

float size_between(const Nature& nature, plant::Random& random, double from, double to) {
  const double t = 0.5 * (random.unit() + random.unit());
  return static_cast<float>((from + (to - from) * t) * nature.scene.vegetation.size);
}

plant::ModelKey any_variant(plant::Species species, plant::Random& random) {
  return {species, static_cast<int>(random.unit() * plant::variant_count(species))};
}

vec2 any_lean(plant::Random& random, double most) {
  const double around = random.turn(), tilt = most * random.unit();
  return {static_cast<float>(tilt * std::cos(around)), static_cast<float>(tilt * std::sin(around))};
}

vec3 any_tint(plant::Random& random, double brightness, double warmth) {
  return random.varied(vec3(1.0f), brightness, warmth);
}

Layer woods_layer(const Nature& nature, std::uint32_t id) {
  Layer layer;
  layer.id = id;
  layer.spacing_m = spacing_of(nature, nature.scene.biome.ground.canopy_m);
  layer.reach_m = nature.scene.vegetation.reach_m;
  layer.highest = nature.rule.highest_tree();
  layer.are_trees = true;
  layer.chance = [&rule = nature.rule](const Site& site) {
    return rule.forest(site.position, site.normal.y, site.noise);
  };
  layer.chance_at_most = [&rule = nature.rule](const Site& site) {
    return rule.forest_at_most(site.position, site.noise);
  };
  return layer;
}

Layer boulder_layer(const Nature& nature, std::uint32_t id, double spacing_m, double reach_m,
                    float heaps) {
  Layer layer;
  layer.id = id;
  layer.spacing_m = spacing_of(nature, spacing_m);
  layer.reach_m = reach_of(nature, reach_m);
  layer.lowest = sea_level(nature) - 0.4f;
  layer.steepest_cos = std::cos(radians_from_degrees(42.0f));
  layer.most = 0.65f + heaps;
  layer.are_stones = true;
  layer.chance = [&rule = nature.rule, heaps](const Site& site) {
    return boulder_chance(rule, site, heaps);
  };
  layer.choose = [nature](const Site& site, plant::Random& random) {
    const ground::GroundMix mix = nature.rule.mix(site.position, site.normal.y, site.noise);
    const auto species = random.chance(static_cast<double>(mix.snow))
                             ? plant::Species::snowy_boulder
                             : plant::Species::boulder;
    Choice choice;
    choice.model = any_variant(species, random);
    // There are many small boulders for each large one.
    const double rank = random.unit();
    choice.scale = size_between(nature, random, 0.35, 0.9) / static_cast<float>(0.3 + 0.9 * rank);
    choice.upright = 0.3f;
    choice.lean = any_lean(random, 0.25);
    choice.tint = any_tint(random, 0.15, 0.06);
    if (species == plant::Species::boulder) {
      choice.tint *= nature.rule.rock_color(site.position, site.noise) / kBoulderAlbedo;
    }
    return choice;
  };
  return layer;
}

}  // namespace aerostat::scatter
