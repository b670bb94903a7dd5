#include "scatter/species.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/smooth_step.hpp"
#include "scene/scene.hpp"

namespace aerostat::scatter {
namespace {

using plant::Random;
using scene::PlantPlace;
using scene::PlantSpecies;

/// The numbers of the layers begin here, above those of the biomes.
constexpr std::uint32_t kFirstLayer = 100;

/// The most plants of one species around the camera, which bounds memory. Denser ones end nearer.
constexpr double kMostAround = 1e6;

/// The height above the sea in metres below which no plant of these species grows. Chosen by eye.
constexpr float kAboveSea_m = 0.6f;

/// Returns the height of the lowest and of the highest plants in metres, without the scene's factor
/// on sizes.
dvec2 heights_of(const PlantSpecies& species, const SpeciesModel& model) {
  return species.height_m.value_or(dvec2(model.height));
}

/// The rules of one species.
class Rules {
 public:
  Rules(const Nature& nature, std::size_t index)
      : nature_(nature),
        index_(index),
        species_(nature.scene.vegetation.species[index]),
        // The steepest slope has the least cosine.
        slope_cos_(glm::cos(glm::radians(dvec2(species_.slope_deg.y, species_.slope_deg.x)))) {}

  /// Returns the probability by which the ground of a site suits the species.
  float suits(const Site& site) const {
    const double height = static_cast<double>(site.position.y);
    const double slope_cos = static_cast<double>(site.normal.y);
    if (height < species_.heights_m.x || height > species_.heights_m.y) return 0.0f;
    // The normal of level ground may be a little longer than 1.
    if (slope_cos < slope_cos_.x || std::min(slope_cos, 1.0) > slope_cos_.y) return 0.0f;
    return species_.cover.empty() ? 1.0f : covered(site);
  }

  Choice choose(Random& random) const {
    const SpeciesModel& model = nature_.species[index_];
    const dvec2 heights = heights_of(species_, model);
    const auto height = static_cast<double>(size_between(nature_, random, heights.x, heights.y));
    Choice choice;
    choice.species = index_;
    choice.scale = static_cast<float>(height / model.height);
    choice.extent_m = std::max(height, model.width * static_cast<double>(choice.scale));
    choice.lean = any_lean(random, 0.03);
    if (species_.tint > 0.0) choice.tint = any_tint(random, species_.tint, 0.5 * species_.tint);
    return choice;
  }

 private:
  float covered(const Site& site) const {
    if (nature_.cover == nullptr) return 0.0f;
    const CoverShares shares = nature_.cover->at(static_cast<double>(site.position.x),
                                                 static_cast<double>(site.position.z));
    float share = 0.0f;
    for (const CoverClass one : species_.cover) {
      if (one != CoverClass::water) share += shares[static_cast<std::size_t>(one)];
    }
    return share;
  }

  const Nature nature_;
  std::size_t index_;
  const PlantSpecies& species_;
  dvec2 slope_cos_;
};

/// Chooses among the species of the woods and the usual trees.
class Mixture {
 public:
  Mixture(const Nature& nature, std::function<Choice(const Site&, Random&)> usual)
      : nature_(nature), usual_(std::move(usual)) {
    const auto& species = nature.scene.vegetation.species;
    for (std::size_t i = 0; i < species.size(); ++i) {
      if (species[i].grows == PlantPlace::woods) rules_.emplace_back(nature, i);
    }
  }

  Choice operator()(const Site& site, Random& random) const {
    const auto& species = nature_.scene.vegetation.species;
    std::vector<double> shares;
    double total = 0.0;
    std::size_t number = 0;
    for (std::size_t i = 0; i < species.size(); ++i) {
      if (species[i].grows != PlantPlace::woods) continue;
      shares.push_back(species[i].share * static_cast<double>(rules_[number++].suits(site)));
      total += shares.back();
    }
    const bool usual = nature_.scene.vegetation.usual;
    double left = random.unit() * (usual ? std::max(total, 1.0) : total);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      if (left < shares[i]) return rules_[i].choose(random);
      left -= shares[i];
    }
    if (usual) return usual_(site, random);
    Choice none;
    none.is_nothing = true;
    return none;
  }

 private:
  const Nature nature_;
  std::function<Choice(const Site&, Random&)> usual_;
  std::vector<Rules> rules_;
};

/// Returns the layer of a species that grows outside of the woods or anywhere.
Layer layer_of(const Nature& nature, std::size_t index) {
  const PlantSpecies& species = nature.scene.vegetation.species[index];
  Layer layer;
  layer.id = kFirstLayer + static_cast<std::uint32_t>(index);
  layer.spacing_m = spacing_of(nature, 100.0 / std::sqrt(species.per_hectare));
  const double most_m = layer.spacing_m * std::sqrt(kMostAround * std::numbers::inv_pi);
  layer.reach_m = std::min(nature.scene.vegetation.reach_m, most_m);
  layer.lowest = std::max(sea_level(nature) + kAboveSea_m, static_cast<float>(species.heights_m.x));
  layer.highest = static_cast<float>(species.heights_m.y);
  const bool is_open = species.grows == PlantPlace::open;
  const Rules rules(nature, index);
  layer.chance = [nature, rules, is_open](const Site& site) {
    const float open =
        is_open ? 1.0f - nature.rule.forest(site.position, site.normal.y, site.noise) : 1.0f;
    return open * rules.suits(site);
  };
  layer.choose = [rules](const Site&, Random& random) { return rules.choose(random); };
  return layer;
}

}  // namespace

void add_species(const Nature& nature, std::vector<Layer>& layers) {
  const scene::Vegetation& vegetation = nature.scene.vegetation;
  if (vegetation.species.empty() && vegetation.usual) return;
  std::erase_if(layers, [&vegetation](const Layer& layer) {
    return !vegetation.usual && !layer.are_trees && !layer.are_stones;
  });
  for (Layer& layer : layers) {
    if (layer.are_trees) layer.choose = Mixture(nature, std::move(layer.choose));
  }
  for (std::size_t i = 0; i < vegetation.species.size(); ++i) {
    const PlantSpecies& species = vegetation.species[i];
    if (species.grows == PlantPlace::woods || !(species.per_hectare > 0.0)) continue;
    layers.push_back(layer_of(nature, i));
  }
}

double greatest_extent(const PlantSpecies& species, const SpeciesModel& model) {
  return heights_of(species, model).y * std::max(1.0, model.width / model.height);
}

}  // namespace aerostat::scatter
