#pragma once

#include "scatter/layer.hpp"

namespace aerostat::scatter {

/// What the layers of a biome go by.
struct Nature {
  const scene::Scene& scene;
  const Surface& surface;
  const GroundRule& rule;
};

/// What grows in a scene's biome. The layers refer to `nature`'s members, which must outlive them.
std::vector<Layer> biome_layers(const Nature& nature);

std::vector<Layer> snow_layers(const Nature& nature);
std::vector<Layer> tropical_layers(const Nature& nature);
std::vector<Layer> sand_layers(const Nature& nature);

/// 0 up to `from`, 1 beyond `to`, smooth between (from > to reverses it).
float ramp(float from, float to, float x);

/// Height of the sea, far below everything if there is none.
float sea_level(const Nature& nature);

/// The side of a square at a spacing for density 1.
double spacing_of(const Nature& nature, double spacing_m);

/// How far a layer reaches that is worth seeing up to `reach_m` when /vegetation/reach_m is 6000.
double reach_of(const Nature& nature, double reach_m);

/// A size between two, most near the middle, times /vegetation/size.
float size_between(const Nature& nature, plant::Random& random, double from, double to);

plant::ModelKey any_variant(plant::Species species, plant::Random& random);

/// A small tilt in any direction, as tangents.
vec2 any_lean(plant::Random& random, double most);

/// White, brighter or darker and warmer or cooler by up to these shares.
vec3 any_tint(plant::Random& random, double brightness, double warmth);

/// Boulders towards bare rock, along shores and, with this probability, in heaps elsewhere; in the
/// colour of the ground's rock.
Layer boulder_layer(const Nature& nature, std::uint32_t id, double spacing_m, double reach_m,
                    float heaps);

}  // namespace aerostat::scatter
