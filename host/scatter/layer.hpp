#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "ground/ground_rule.hpp"
#include "plant/random.hpp"
#include "scatter/circles.hpp"
#include "scatter/scatter.hpp"
#include "scatter/sight.hpp"
#include "scatter/surface.hpp"

namespace aerostat::scatter {

/// The distance from its axis within which a plant keeps out of circles, in heights of it.
inline constexpr double kPlantReach = 0.35;

/// A place where a plant or stone may stand.
struct Site {
  /// The position over the terrain in metres, as all positions here. y is the height above the sea.
  vec3 position{0.0f};
  vec3 normal{0.0f, 1.0f, 0.0f};
  /// The height above the sea in metres. It is very large if there is no sea.
  float above_sea = 0.0f;
  ground::GroundNoise noise{};
};

/// The plant or stone that stands at a site.
struct Choice {
  /// The model, unless the plant is of a species from a file.
  plant::ModelKey model;
  /// The species from a file, as an index into Vegetation::species.
  std::optional<std::size_t> species = {};
  /// The greater of the height and the width in metres of a plant from a file.
  double extent_m = 0.0;
  /// Tells that nothing grows there after all.
  bool is_nothing = false;
  float scale = 1.0f;
  /// The direction of the axis: 1 is plumb, and 0 is at right angles to the ground.
  float upright = 1.0f;
  /// An additional tilt of the axis in x and z, as tangents.
  vec2 lean{0.0f};
  vec3 tint{1.0f};
};

/// One kind of growth. It is a jittered grid with a candidate in every square.
struct Layer {
  /// A number that separates the grid and the random numbers of this layer from those of others.
  std::uint32_t id = 0;
  /// The side of a square in metres.
  double spacing_m = 10.0;
  /// The distance in metres beyond which nothing grows. Growth thins out over the outer half.
  double reach_m = 1000.0;
  /// The range of heights of the ground on which the layer grows, in metres.
  float lowest = -kInfinity;
  float highest = kInfinity;
  /// The cosine of the steepest slope on which the layer grows.
  float steepest_cos = 0.0f;
  /// An upper bound of `chance`.
  float most = 1.0f;
  /// Returns the probability that a candidate grows at its site.
  std::function<float(const Site&)> chance;
  /// Returns an upper bound of `chance` that does not need the noise's `rough`, which is expensive.
  /// If it is null, only `most` bounds `chance`.
  std::function<float(const Site&)> chance_at_most;
  std::function<Choice(const Site&, plant::Random&)> choose;
  /// Tells whether the layer has the trees of the woods and their outskirts, or stones.
  bool are_trees = false;
  bool are_stones = false;
};

/// The ground, the sea and the other data that layers are placed with. Squares are counted by
/// places over the terrain.
struct Place {
  const Surface& surface;
  const ground::GroundRule& rule;
  /// The height of the sea in metres, far below everything if there is none.
  float sea_level_m;
  /// The place from which reaches are counted.
  dvec2 center;
  const Circles& keep_out;
  std::uint32_t seed;
  /// The sight outside of which squares stay empty, or null if it does not limit the layers.
  const Sight* sight;
  /// The height in metres that no plant exceeds.
  double tallest_m;
};

/// Returns the instances of a layer in the order of its squares. Their models are indices into
/// `models`, which must contain every model that `choose` returns. Those of species from files
/// follow them in the order of Vegetation::species. It runs on all cores, and the bits do not
/// depend on their number.
std::vector<Instance> place_layer(const Layer& layer, const Place& place,
                                  std::span<const plant::ModelKey> models);

}  // namespace aerostat::scatter
