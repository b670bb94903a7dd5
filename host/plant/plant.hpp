#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

/// Builds the plants and stones of all biomes by functions from a few measures and a seed.
namespace aerostat::plant {

enum class Species {
  spruce,
  snowy_spruce,
  palm,
  broadleaf,
  larch,
  /// A larch in autumn.
  golden_larch,
  birch,
  /// A birch in autumn.
  golden_birch,
  acacia,
  /// A green shrub of moist places.
  shrub,
  /// A feathery, grey-green bush of dry places.
  scrub,
  /// A tuft of dry grass.
  tussock,
  /// A neutral grey boulder. The tint of an instance gives it the colour of the ground.
  boulder,
  /// A boulder with a cap of snow.
  snowy_boulder,
  driftwood,
  count
};
inline constexpr int kSpeciesCount = static_cast<int>(Species::count);

/// The level of detail of a model. It limits the triangles of the largest species to 20,000, 2,000,
/// 250 and 78. The outline is a closed body without leaves. Plants without a closed crown, and
/// those whose far model has no more triangles than that, have the far model for it.
enum class Detail { near, middle, far, outline };

/// One model of a species, with 0 <= variant < variant_count(species).
struct ModelKey {
  Species species = Species::spruce;
  int variant = 0;

  bool operator==(const ModelKey&) const = default;
};

int variant_count(Species species);

/// Returns a word for messages, such as "snowy_spruce".
const char* species_name(Species species);

/// Returns the height of the model's top above the ground in metres. It is the same at every level
/// of detail.
double model_height(const ModelKey& model);

/// Builds a model with its foot at the origin and y up. Some of it is below the ground, so that it
/// can stand on slopes. Vertex colours are linear albedo with the crown's own shade baked in.
/// Foliage consists of flat leaves that are meant to be seen from both sides, with normals bent
/// outwards. The levels of detail share silhouette, colour and volume. Equal arguments give equal
/// bits. Throws Error{internal} if there is no such variant.
mesh::TriangleMesh build(const ModelKey& model, Detail detail);

}  // namespace aerostat::plant
