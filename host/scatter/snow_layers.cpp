#include <algorithm>
#include <cmath>

#include "core/smooth_step.hpp"
#include "scatter/biome_layers.hpp"
#include "scene/scene.hpp"

namespace aerostat::scatter {
namespace {

using plant::Random;
using plant::Species;

// The width of the spruce models in metres. For a canopy of this width, the models keep their size.
constexpr double kCrown = 5.8;

/// Returns a spruce for a site. Trees have snow where the ground has snow, and more of them have
/// snow higher up.
Choice choose_spruce(const Nature& nature, const Site& site, Random& random, double from,
                     double to) {
  const scene::Ground& ground = nature.scene.biome.ground;
  const ground::GroundMix mix = nature.rule.mix(site.position, site.normal.y, site.noise);
  const float up = site.position.y / std::max(static_cast<float>(ground.forest_top_m), 1.0f);
  const float laden =
      mix.snow * (0.45f + 0.45f * smooth_step(0.2f, 0.9f, up) + 0.3f * site.noise.fine);
  Choice choice;
  choice.model.species =
      random.chance(static_cast<double>(laden)) ? Species::snowy_spruce : Species::spruce;
  // The slender variant grows high up.
  const bool slender =
      random.chance(0.15 + 0.6 * static_cast<double>(smooth_step(0.45f, 0.9f, up)));
  choice.model.variant = slender ? 1 : (random.chance(0.3) ? 2 : 0);
  const float stunted = 1.0f - 0.5f * nature.rule.thinning(site.position, site.noise);
  choice.scale = size_between(nature, random, from, to) * stunted *
                 static_cast<float>(ground.canopy_m / kCrown);
  choice.lean = any_lean(random, 0.04);
  choice.tint = any_tint(random, 0.22, 0.1 + 0.1 * static_cast<double>(site.noise.broad));
  return choice;
}

Layer woods(const Nature& nature) {
  Layer layer = woods_layer(nature, 1);
  layer.choose = [nature](const Site& site, Random& random) {
    return choose_spruce(nature, site, random, 0.55, 1.25);
  };
  return layer;
}

/// Returns a layer of young and single trees around the woods, so that their edges do not look like
/// walls.
Layer outskirts(const Nature& nature) {
  Layer layer;
  layer.id = 2;
  layer.are_trees = true;
  layer.spacing_m = spacing_of(nature, 1.6 * nature.scene.biome.ground.canopy_m);
  layer.reach_m = reach_of(nature, 4000.0);
  layer.highest = nature.rule.highest_tree();
  layer.steepest_cos = std::cos(radians_from_degrees(38.0f));
  layer.most = 0.45f;
  layer.chance = [&rule = nature.rule](const Site& site) {
    const float close = rule.closeness(site.position, site.noise);
    if (close > 0.0f || close < -0.45f) return 0.0f;
    return 0.45f * smooth_step(-0.45f, 0.0f, close) * smooth_step(-0.3f, 0.5f, site.noise.fine);
  };
  layer.chance_at_most = layer.chance;
  layer.choose = [nature](const Site& site, Random& random) {
    return choose_spruce(nature, site, random, 0.15, 0.75);
  };
  return layer;
}

}  // namespace

std::vector<Layer> snow_layers(const Nature& nature) {
  return {woods(nature), outskirts(nature), boulder_layer(nature, 3, 9.0, 1500.0, 0.1f)};
}

}  // namespace aerostat::scatter
