#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

/// Plants and stones of the three biomes, built by functions from a few measures and a seed.
namespace aerostat::plant {

enum class Species {
  spruce,
  snowy_spruce,
  palm,
  broadleaf,
  acacia,
  shrub,          // green, of moist places
  scrub,          // feathery and grey-green, of dry ones
  tussock,        // dry grass
  boulder,        // grey and neutral: an instance's tint gives it the colour of its ground
  snowy_boulder,  // with a cap of snow
  driftwood,
  count
};
inline constexpr int kSpeciesCount = static_cast<int>(Species::count);

/// How many triangles a model may have: the largest kinds 20,000, 2,000 and 250.
enum class Detail { near, middle, far };

/// One model of a species, 0 <= variant < variant_count(species).
struct ModelKey {
  Species species = Species::spruce;
  int variant = 0;

  bool operator==(const ModelKey&) const = default;
};

int variant_count(Species species);

/// A word for messages, such as "snowy_spruce".
const char* species_name(Species species);

/// Top of the model above the ground, in metres, at every level of detail.
double model_height(const ModelKey& model);

/// The model with its foot at the origin and y up, some of it below the ground so that it stands on
/// slopes. Vertex colours are linear albedo with the crown's own shade baked in; foliage consists
/// of flat leaves that are meant to be seen from both sides, with normals bent outwards. The levels
/// share silhouette, colour and volume. Equal arguments give equal bits.
/// Throws Error{internal} if there is no such variant.
mesh::TriangleMesh build(const ModelKey& model, Detail detail);

}  // namespace aerostat::plant
