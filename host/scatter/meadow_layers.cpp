#include <algorithm>
#include <cmath>

#include "core/smooth_step.hpp"
#include "scatter/biome_layers.hpp"
#include "scene/scene.hpp"

namespace aerostat::scatter {
namespace {

using plant::Random;
using plant::Species;
using scene::Season;

// The width of the larch models in metres. For a canopy of this width, the models keep their size.
constexpr double kCrown = 5.8;

/// Returns the leaves of a season. In autumn, some trees are still green.
Species in_season(const Nature& nature, Species green, Species golden, Random& random) {
  const bool autumn = nature.scene.biome.season == Season::autumn;
  return autumn && random.chance(0.88) ? golden : green;
}

/// Returns the factor on the colour of leaves. Young leaves are bright and yellowish.
vec3 leaf_tint(const Nature& nature, Random& random) {
  const vec3 any = any_tint(random, 0.2, 0.14);
  return nature.scene.biome.season == Season::spring ? any * vec3(1.12f, 1.25f, 0.9f) : any;
}

/// Returns the kind of tree of a place. Birches stand low and at the edges, spruces in dark groups,
/// and larches everywhere else.
Species kind_of_tree(const Nature& nature, const Site& site, Random& random) {
  const float edge =
      1.0f - smooth_step(0.0f, 0.35f, nature.rule.closeness(site.position, site.noise));
  const float birches = 0.15f + 0.5f * edge + 0.5f * site.noise.fine;
  const float spruces = 0.75f * smooth_step(0.05f, 0.35f, -site.noise.broad) * (1.0f - edge);
  if (random.chance(static_cast<double>(spruces))) return Species::spruce;
  if (random.chance(static_cast<double>(birches))) {
    return in_season(nature, Species::birch, Species::golden_birch, random);
  }
  return in_season(nature, Species::larch, Species::golden_larch, random);
}

Choice choose_tree(const Nature& nature, const Site& site, Random& random, double from, double to) {
  const double canopy = nature.scene.biome.ground.canopy_m;
  const float stunted = 1.0f - 0.5f * nature.rule.thinning(site.position, site.noise);
  Choice choice;
  choice.model = any_variant(kind_of_tree(nature, site, random), random);
  choice.scale =
      size_between(nature, random, from, to) * stunted * static_cast<float>(canopy / kCrown);
  choice.lean = any_lean(random, 0.05);
  choice.tint = leaf_tint(nature, random);
  return choice;
}

Layer woods(const Nature& nature) {
  Layer layer = woods_layer(nature, 31);
  layer.lowest = sea_level(nature) + 0.6f;
  layer.choose = [nature](const Site& site, Random& random) {
    return choose_tree(nature, site, random, 0.5, 1.15);
  };
  return layer;
}

/// Returns a layer of single trees before the woods and of a few amid the meadows.
Layer outskirts(const Nature& nature) {
  Layer layer;
  layer.id = 32;
  layer.are_trees = true;
  layer.spacing_m = spacing_of(nature, 2.0 * nature.scene.biome.ground.canopy_m);
  layer.reach_m = reach_of(nature, 5000.0);
  layer.lowest = sea_level(nature) + 0.6f;
  layer.highest = nature.rule.highest_tree();
  layer.steepest_cos = std::cos(radians_from_degrees(38.0f));
  layer.most = 0.4f;
  layer.chance = [&rule = nature.rule](const Site& site) {
    const float close = rule.closeness(site.position, site.noise);
    if (close > 0.0f) return 0.0f;
    const float near = smooth_step(-0.35f, 0.0f, close) * smooth_step(-0.3f, 0.5f, site.noise.fine);
    return 0.37f * near + 0.006f;
  };
  layer.chance_at_most = layer.chance;
  layer.choose = [nature](const Site& site, Random& random) {
    return choose_tree(nature, site, random, 0.3, 1.0);
  };
  return layer;
}

/// Returns how likely a hedge is at a place with this slope: along many of the fields' edges.
float hedge_chance(const ground::GroundRule& rule, const Site& site, float slope_cos) {
  if (!rule.has_fields()) return 0.0f;
  const rules::FieldAt field = rule.field(site.position, slope_cos, site.noise);
  const float on_edge = 1.0f - smooth_step(1.2f, 2.2f, field.edge);
  return on_edge * field.share * smooth_step(-0.15f, 0.2f, site.noise.fine);
}

Layer hedges(const Nature& nature) {
  Layer layer;
  layer.id = 33;
  layer.spacing_m = spacing_of(nature, 2.4);
  layer.reach_m = reach_of(nature, 2500.0);
  layer.lowest = sea_level(nature) + 0.8f;
  layer.steepest_cos = FIELD_STEEP_COS;
  layer.most = 0.8f;
  layer.chance = [&rule = nature.rule](const Site& site) {
    return 0.8f * hedge_chance(rule, site, site.normal.y);
  };
  // Fields are most likely on level ground.
  layer.chance_at_most = [&rule = nature.rule](const Site& site) {
    return 0.8f * hedge_chance(rule, site, 1.0f);
  };
  layer.choose = [nature](const Site& site, Random& random) {
    if (random.chance(0.04)) return choose_tree(nature, site, random, 0.35, 0.8);
    const bool autumn = nature.scene.biome.season == Season::autumn;
    Choice choice;
    choice.model = any_variant(Species::shrub, random);
    choice.scale = size_between(nature, random, 0.6, 1.5);
    choice.tint = leaf_tint(nature, random);
    if (autumn && random.chance(0.5)) choice.tint *= vec3(1.9f, 1.0f, 0.7f);
    return choice;
  };
  return layer;
}

Layer shrubs(const Nature& nature) {
  Layer layer;
  layer.id = 34;
  layer.spacing_m = spacing_of(nature, 6.0);
  layer.reach_m = reach_of(nature, 1400.0);
  layer.lowest = sea_level(nature) + 0.4f;
  layer.steepest_cos = std::cos(radians_from_degrees(40.0f));
  layer.most = 0.35f;
  layer.chance = [&rule = nature.rule](const Site& site) {
    const float close = rule.closeness(site.position, site.noise);
    const float shore = smooth_step(6.0f, 1.5f, site.above_sea);
    const float edge = smooth_step(-0.3f, 0.0f, close) * smooth_step(0.3f, 0.0f, close);
    return 0.35f * std::max(edge, 0.8f * shore) * smooth_step(-0.3f, 0.4f, site.noise.fine);
  };
  layer.chance_at_most = layer.chance;
  layer.choose = [nature](const Site&, Random& random) {
    Choice choice;
    choice.model = any_variant(Species::shrub, random);
    choice.scale = size_between(nature, random, 0.4, 1.2);
    choice.upright = 0.7f;
    choice.tint = leaf_tint(nature, random);
    return choice;
  };
  return layer;
}

/// Returns the layer of tall grass near the camera.
Layer grass(const Nature& nature) {
  Layer layer;
  layer.id = 35;
  layer.spacing_m = spacing_of(nature, 1.6);
  layer.reach_m = reach_of(nature, 500.0);
  layer.lowest = sea_level(nature) + 0.3f;
  layer.steepest_cos = std::cos(radians_from_degrees(35.0f));
  layer.most = 0.5f;
  layer.chance = [&rule = nature.rule](const Site& site) {
    const float open = rule.closeness(site.position, site.noise) < 0.0f ? 1.0f : 0.25f;
    return 0.5f * open * smooth_step(-0.2f, 0.5f, site.noise.fine);
  };
  layer.chance_at_most = layer.chance;
  layer.choose = [nature](const Site&, Random& random) {
    Choice choice;
    choice.model = any_variant(Species::tussock, random);
    choice.scale = size_between(nature, random, 0.5, 1.1);
    choice.upright = 0.5f;
    choice.lean = any_lean(random, 0.15);
    choice.tint = any_tint(random, 0.2, 0.15) * vec3(0.62f, 0.85f, 0.45f);
    return choice;
  };
  return layer;
}

}  // namespace

std::vector<Layer> meadow_layers(const Nature& nature) {
  return {woods(nature),  outskirts(nature), hedges(nature),
          shrubs(nature), grass(nature),     boulder_layer(nature, 36, 16.0, 1200.0, 0.01f)};
}

}  // namespace aerostat::scatter
