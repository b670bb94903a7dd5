#pragma once

#include "scene/field.hpp"
#include "scene/land.hpp"
#include "scene/plant_fields.hpp"

/// What stands on the ground.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<Clearing> =
    table("A circle in which nothing grows.",
          field("center", &Clearing::center,
                number(-1e6, 1e6, "Middle of the circle, [x, z] in metres, each {from} to {to}.")
                    .required()),
          field("radius_m", &Clearing::radius_m,
                number(0, 100000, "Radius of the circle in metres, {from} to {to}.")));

template <>
inline constexpr auto kTable<Vegetation> = table(
    "Plants and stones on the ground. The biome determines what grows where.",
    field("enabled", &Vegetation::enabled,
          truth("Whether there are plants and stones.").control(EditGroup::plants, "Plants")),
    field("density", &Vegetation::density,
          number(0, 4,
                 "Number of plants per area relative to the usual number of the biome, {from} "
                 "(none) to {to}.")
              .slider(EditGroup::plants, "Density", 0, 2, 2)),
    field("size", &Vegetation::size,
          number(0.1, 10, "Factor on the height of every plant and stone, {from} to {to}.")
              .slider(EditGroup::plants, "Size of plants", 0.3, 3, 2)),
    field("reach_m", &Vegetation::reach_m,
          number(10, 12000,
                 "Distance from the camera in metres up to which single trees stand, {from} to "
                 "{to}. Farther woods are painted on the ground. Smaller plants end at "
                 "proportionally smaller distances.")
              .slider(EditGroup::plants, "Single trees up to", 500, 12000, 0, Scale::logarithmic)),
    field("seed", &Vegetation::seed,
          number(0, 4294967295,
                 "Seed of the plants, {from} to {to}. Each seed places them elsewhere.")
              .slider(EditGroup::plants, "Seed of plants", 1, 1000)),
    field("clearings", &Vegetation::clearings,
          list(kMostClearings,
               "Circles in which nothing grows, at most {to}. A film adds those that its camera "
               "and its balloons fly through, so that no plant vanishes before them.")),
    field("usual", &Vegetation::usual,
          truth("Whether the usual plants of the biome grow. Without them, stones and the species "
                "from files remain.")
              .control(EditGroup::plants, "Plants of the biome")),
    field("species", &Vegetation::species,
          list(kMostSpecies,
               "Species of plants from files, at most {to}, which grow beside the "
               "usual ones or in their place.")));

}  // namespace aerostat::scene::detail
