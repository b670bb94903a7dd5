#include <algorithm>
#include <cmath>

#include "core/smooth_step.hpp"
#include "rules/ground.h"
#include "scatter/biome_layers.hpp"
#include "scene/scene.hpp"

namespace aerostat::scatter {
namespace {

using plant::Random;
using plant::Species;

// The width of the broadleaf models in metres.
constexpr double kCrown = 9.6;

/// Returns a palm for a site. Palms lean down the slope, towards the light over the water.
Choice choose_palm(const Nature& nature, const Site& site, Random& random) {
  Choice choice;
  choice.model = any_variant(Species::palm, random);
  choice.scale = size_between(nature, random, 0.65, 1.2);
  const float tilt = static_cast<float>(random.range(0.0, 0.22));
  const vec2 down(site.normal.x, site.normal.z);
  const float steep = glm::length(down);
  choice.lean = any_lean(random, 0.12);
  if (steep > 1e-4f) choice.lean += down * (tilt / steep);
  choice.tint = any_tint(random, 0.14, 0.12);
  return choice;
}

/// Returns a tint by which trees of a kind stand together. Some groups are yellower and brighter,
/// others bluer and darker, and a few crowns are pale. Painted woods vary in the same way.
vec3 kind_tint(const ground::GroundNoise& noise, Random& random) {
  const float warm = WOODS_WARMTH_OF_BROAD * noise.broad + WOODS_WARMTH_OF_FINE * noise.fine;
  const vec3 hue(1.0f + WARM_RED * warm, 1.0f + WARM_TREE_GREEN * warm, 1.0f - WARM_BLUE * warm);
  const float pale = random.chance(0.03) ? 1.5f : 1.0f;
  return hue * (pale * (1.0f + 0.3f * noise.broad));
}

Layer woods(const Nature& nature) {
  const double canopy = nature.scene.biome.ground.canopy_m;
  Layer layer = woods_layer(nature, 11);
  layer.lowest = sea_level(nature) + 1.0f;
  layer.choose = [nature, canopy](const Site& site, Random& random) {
    const float shore = smooth_step(30.0f, 4.0f, site.above_sea);
    if (random.chance(0.45 * static_cast<double>(shore))) return choose_palm(nature, site, random);
    Choice choice;
    choice.model = any_variant(Species::broadleaf, random);
    choice.scale = size_between(nature, random, 0.6, 1.3) * static_cast<float>(canopy / kCrown);
    choice.lean = any_lean(random, 0.07);
    choice.tint = any_tint(random, 0.22, 0.2) * kind_tint(site.noise, random);
    return choice;
  };
  return layer;
}

/// Returns the layer of coconut palms along the beach, above the reach of the waves.
Layer palms(const Nature& nature) {
  const auto top = std::max(static_cast<float>(nature.scene.biome.ground.beach_top_m), 0.0f);
  Layer layer;
  layer.id = 12;
  layer.spacing_m = spacing_of(nature, 6.5);
  layer.reach_m = reach_of(nature, 5000.0);
  layer.lowest = sea_level(nature) + 1.3f;
  layer.highest = sea_level(nature) + top + 9.0f;
  layer.steepest_cos = std::cos(radians_from_degrees(20.0f));
  layer.most = 0.75f;
  layer.chance = [top](const Site& site) {
    const float band = smooth_step(1.3f, 2.2f, site.above_sea) *
                       smooth_step(top + 9.0f, top + 3.0f, site.above_sea);
    return 0.75f * band * smooth_step(-0.35f, 0.55f, site.noise.fine + 0.5f * site.noise.broad);
  };
  layer.chance_at_most = layer.chance;
  layer.choose = [nature](const Site& site, Random& random) {
    return choose_palm(nature, site, random);
  };
  return layer;
}

/// Returns the layer of shrubs on open ground and along the woods.
Layer shrubs(const Nature& nature) {
  Layer layer;
  layer.id = 13;
  layer.spacing_m = spacing_of(nature, 3.6);
  layer.reach_m = reach_of(nature, 1100.0);
  layer.lowest = sea_level(nature) + 1.6f;
  layer.steepest_cos = std::cos(radians_from_degrees(40.0f));
  layer.most = 0.55f;
  layer.chance = [&rule = nature.rule](const Site& site) {
    const float open = 1.0f - rule.forest(site.position, site.normal.y, site.noise);
    return 0.55f * (0.15f + 0.85f * open) * smooth_step(-0.25f, 0.6f, site.noise.fine);
  };
  layer.chance_at_most = [](const Site& site) {
    // The bound is slightly larger than 0.55 because of rounding.
    return 0.551f * smooth_step(-0.25f, 0.6f, site.noise.fine);
  };
  layer.choose = [nature](const Site&, Random& random) {
    Choice choice;
    choice.model = any_variant(Species::shrub, random);
    choice.scale = size_between(nature, random, 0.4, 1.2);
    choice.upright = 0.6f;
    choice.tint = any_tint(random, 0.22, 0.2);
    return choice;
  };
  return layer;
}

Layer driftwood(const Nature& nature) {
  Layer layer;
  layer.id = 14;
  layer.are_stones = true;
  layer.spacing_m = spacing_of(nature, 17.0);
  layer.reach_m = reach_of(nature, 900.0);
  layer.lowest = sea_level(nature) + 0.5f;
  layer.highest = sea_level(nature) + 3.0f;
  layer.steepest_cos = std::cos(radians_from_degrees(14.0f));
  layer.most = 0.3f;
  layer.chance = [](const Site& site) {
    return 0.3f * smooth_step(0.5f, 0.9f, site.above_sea) * smooth_step(3.0f, 2.0f, site.above_sea);
  };
  layer.chance_at_most = layer.chance;
  layer.choose = [nature](const Site&, Random& random) {
    Choice choice;
    choice.model = any_variant(Species::driftwood, random);
    choice.scale = size_between(nature, random, 0.4, 1.2);
    choice.upright = 0.0f;
    choice.tint = any_tint(random, 0.2, 0.08);
    return choice;
  };
  return layer;
}

}  // namespace

std::vector<Layer> tropical_layers(const Nature& nature) {
  std::vector<Layer> layers{woods(nature), shrubs(nature),
                            boulder_layer(nature, 15, 8.0, 1500.0, 0.1f)};
  if (nature.scene.biome.water.enabled) {
    layers.push_back(palms(nature));
    layers.push_back(driftwood(nature));
  }
  return layers;
}

}  // namespace aerostat::scatter
