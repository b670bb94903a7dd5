#pragma once

#include "scatter/layer.hpp"

namespace aerostat::scatter {

/// The data by which the layers of a biome place plants and stones.
struct Nature {
  const scene::Scene& scene;
  const Surface& surface;
  const ground::GroundRule& rule;
  /// The land cover, or null if there is none.
  const CoverLookup* cover = nullptr;
  /// The models of the species from files.
  std::span<const SpeciesModel> species = {};
};

/// Returns the layers of plants and stones in a scene's biome. The layers refer to the members of
/// `nature`, which must outlive them.
std::vector<Layer> biome_layers(const Nature& nature);

std::vector<Layer> snow_layers(const Nature& nature);
std::vector<Layer> tropical_layers(const Nature& nature);
std::vector<Layer> sand_layers(const Nature& nature);
std::vector<Layer> meadow_layers(const Nature& nature);

/// Returns the height of the sea, or a height far below everything if there is none.
float sea_level(const Nature& nature);

/// Returns the side of a square in metres. It is `spacing_m` for density 1.
double spacing_of(const Nature& nature, double spacing_m);

/// Returns the reach of a layer in metres. It is `reach_m` if /vegetation/reach_m is 6000.
double reach_of(const Nature& nature, double reach_m);

/// Returns a random size between `from` and `to` times /vegetation/size. Most sizes are near the
/// middle.
float size_between(const Nature& nature, plant::Random& random, double from, double to);

plant::ModelKey any_variant(plant::Species species, plant::Random& random);

/// Returns a small random tilt in any direction as tangents.
vec2 any_lean(plant::Random& random, double most);

/// Returns white made brighter or darker and warmer or cooler by random amounts up to these shares.
vec3 any_tint(plant::Random& random, double brightness, double warmth);

/// Returns a layer of trees where the rules of the ground have woods, a tree for each crown. It
/// does not choose trees yet.
Layer woods_layer(const Nature& nature, std::uint32_t id);

/// Returns a layer of boulders. They stand towards bare rock, along shores and, with the
/// probability `heaps`, in heaps elsewhere. They have the colour of the ground's rock.
Layer boulder_layer(const Nature& nature, std::uint32_t id, double spacing_m, double reach_m,
                    float heaps);

}  // namespace aerostat::scatter
