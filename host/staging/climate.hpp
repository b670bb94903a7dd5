#pragma once

#include <vector>

#include "geo/place.hpp"
#include "scene/io.hpp"
#include "scene/land.hpp"

namespace aerostat::staging {

/// What grows and lies at a place, as its latitude, its heights and the season have it. The figures
/// are averages over all longitudes, so that a place may well differ by some hundred metres.
struct Climate {
  scene::BiomeKind biome = scene::BiomeKind::meadow;
  scene::Season season = scene::Season::summer;
  bool is_brown = false;     // grass is dry, and trees are few
  double snow_line_m = 0.0;  // mean height above which snow lies at this time of the year
  double tree_line_m = 0.0;  // mean height up to which trees grow
};

/// Returns the climate of a place. `month` is 1 to 12 with fractions: 1 is the start of January.
/// `lowest_m` and `highest_m` are the heights of the land that is seen.
Climate climate_of(const geo::Place& place, double month, double lowest_m, double highest_m);

/// Returns the values of a scene that follow from a climate: the biome, its season, lines and
/// colours.
std::vector<scene::Override> biome_values(const Climate& climate, bool has_sea);

}  // namespace aerostat::staging
