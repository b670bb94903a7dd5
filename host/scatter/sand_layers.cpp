#include <algorithm>
#include <cmath>

#include "core/smooth_step.hpp"
#include "scatter/biome_layers.hpp"
#include "scene/scene.hpp"

namespace aerostat::scatter {
namespace {

using plant::Random;
using plant::Species;

// The width of the spruce models in metres.
constexpr double kCrown = 5.8;

// The distance in metres at which the height around a place tells a hollow from a crest. Chosen by
// eye.
constexpr double kAroundM = 45.0;

/// Returns 1 on the floors between dunes, where water gathers, and 0 on their flanks and crests.
float hollow(const Surface& surface, const Site& site) {
  const double x = static_cast<double>(site.position.x), z = static_cast<double>(site.position.z);
  float around = 0.0f;
  for (const double side : {-kAroundM, kAroundM}) {
    around += surface.height(x + side, z) + surface.height(x, z + side);
  }
  return smooth_step(-0.5f, 4.0f, 0.25f * around - site.position.y) *
         smooth_step(0.94f, 0.985f, site.normal.y);
}

/// Returns a layer of the plants between the dunes. `chance` is the probability at the wettest
/// places.
Layer floor_layer(const Nature& nature, std::uint32_t id, double spacing_m, double reach_m,
                  float chance, float bare_below) {
  Layer layer;
  layer.id = id;
  layer.spacing_m = spacing_of(nature, spacing_m);
  layer.reach_m = reach_of(nature, reach_m);
  layer.steepest_cos = std::cos(radians_from_degrees(18.0f));
  layer.most = chance;
  layer.chance_at_most = [chance, bare_below](const Site& site) {
    return chance * smooth_step(bare_below, bare_below + 0.7f, site.noise.fine + site.noise.broad);
  };
  layer.chance = [&surface = nature.surface, clump = layer.chance_at_most](const Site& site) {
    const float likely = clump(site);
    return likely > 0.0f ? likely * hollow(surface, site) : 0.0f;
  };
  return layer;
}

/// Returns a tint with the colour of straw and dust. Without it, dark shrubs would be dots on
/// bright sand.
vec3 dusty_tint(Random& random) {
  return any_tint(random, 0.2, 0.15) * vec3(1.75f, 1.45f, 1.05f);
}

Layer scrub(const Nature& nature) {
  Layer layer = floor_layer(nature, 21, 6.0, 3000.0, 0.55f, 0.0f);
  layer.choose = [nature](const Site&, Random& random) {
    Choice choice;
    choice.model = any_variant(Species::scrub, random);
    choice.scale = size_between(nature, random, 0.45, 1.35);
    choice.upright = 0.7f;
    choice.lean = any_lean(random, 0.08);
    choice.tint = dusty_tint(random);
    return choice;
  };
  return layer;
}

Layer grass(const Nature& nature) {
  Layer layer = floor_layer(nature, 22, 2.2, 900.0, 0.6f, -0.25f);
  layer.choose = [nature](const Site&, Random& random) {
    Choice choice;
    choice.model = any_variant(Species::tussock, random);
    choice.scale = size_between(nature, random, 0.5, 1.4);
    choice.upright = 0.4f;
    choice.lean = any_lean(random, 0.15);
    choice.tint = dusty_tint(random);
    return choice;
  };
  return layer;
}

Layer acacias(const Nature& nature) {
  Layer layer = floor_layer(nature, 23, 60.0, 5000.0, 0.5f, -0.2f);
  layer.choose = [nature](const Site&, Random& random) {
    Choice choice;
    choice.model = any_variant(Species::acacia, random);
    choice.scale = size_between(nature, random, 0.6, 1.2);
    choice.lean = any_lean(random, 0.08);
    choice.tint = any_tint(random, 0.15, 0.15);
    return choice;
  };
  return layer;
}

/// Returns the layer of woods that land cover knows in dry land: conifers as wide as the crowns
/// that are painted.
Layer dry_woods(const Nature& nature) {
  Layer layer = woods_layer(nature, 25);
  layer.choose = [nature](const Site&, Random& random) {
    Choice choice;
    choice.model = any_variant(Species::spruce, random);
    choice.scale = size_between(nature, random, 0.45, 1.05) *
                   static_cast<float>(nature.scene.biome.ground.canopy_m / kCrown);
    choice.lean = any_lean(random, 0.06);
    choice.tint = any_tint(random, 0.2, 0.12) * vec3(1.25f, 1.1f, 0.95f);
    return choice;
  };
  return layer;
}

}  // namespace

std::vector<Layer> sand_layers(const Nature& nature) {
  std::vector<Layer> layers = {scrub(nature), grass(nature), acacias(nature),
                               boulder_layer(nature, 24, 11.0, 3000.0, 0.012f)};
  if (nature.rule.has_cover()) layers.push_back(dry_woods(nature));
  return layers;
}

}  // namespace aerostat::scatter
