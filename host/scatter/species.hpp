#pragma once

#include <vector>

#include "scatter/biome_layers.hpp"
#include "scene/land.hpp"

/// Species from files among the plants of a biome.
namespace aerostat::scatter {

/// Lets the scene's species from files grow: trees of the layers of trees become theirs by their
/// shares, and each species that grows elsewhere has a layer of its own. If the usual plants of the
/// biome do not grow, only these and the stones stay. The layers refer to the members of `nature`,
/// which must outlive them.
void add_species(const Nature& nature, std::vector<Layer>& layers);

/// Returns the greatest height or width in metres that a plant of the species can have.
double greatest_extent(const scene::PlantSpecies& species, const SpeciesModel& model);

}  // namespace aerostat::scatter
