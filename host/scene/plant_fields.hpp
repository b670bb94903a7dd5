#pragma once

#include "scene/field.hpp"
#include "scene/land.hpp"

/// Species of plants from files.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<PlantSpecies> = table(
    "Species of plants whose shape is a model from a file. Its foot is the lowest point, in the "
    "middle of its bounding box.",
    field("file", &PlantSpecies::file,
          text("Name of a glTF (.glb, .gltf), OBJ, PLY or STL file, relative to the folder of the "
               "scene file.")
              .required()),
    field("up", &PlantSpecies::up, word("Axis of the file that points up, y by default.")),
    field("grows", &PlantSpecies::grows,
          word("Where the plants grow: in the woods (the default) in place of some of their trees, "
               "in the open outside of the woods, or anywhere on dry land.")),
    field("height_m", &PlantSpecies::height_m,
          number(0, 1000,
                 "Least and greatest height of the plants in metres, each {from} to {to}. By "
                 "default, all are as high as the model in the file. The size of /vegetation "
                 "multiplies it.")
              .above()),
    field("share", &PlantSpecies::share,
          number(0, 1,
                 "Share of the trees of the woods that are of this species, {from} to {to}. If the "
                 "shares of all species together exceed 1, or if the biome's own do not grow, they "
                 "count in proportion.")),
    field("per_hectare", &PlantSpecies::per_hectare,
          number(0, 10000,
                 "Number of plants on a hectare, {from} to {to}, if they do not grow in the woods. "
                 "The density of /vegetation multiplies it.")),
    field("slope_deg", &PlantSpecies::slope_deg,
          number(0, 90, "Least and greatest slope of the ground in degrees, each {from} to {to}.")),
    field("heights_m", &PlantSpecies::heights_m,
          number(-12000, 12000,
                 "Least and greatest height of the ground above the sea in metres.")),
    field(
        "cover", &PlantSpecies::cover,
        list(9,
             "Classes of land cover on which the plants grow, at most {to}. By default, they grow "
             "on any. Where the scene has no land cover, plants with this rule do not grow.")),
    field("tint", &PlantSpecies::tint,
          number(0, 1,
                 "Share by which the brightness of the plants differs from that of the file at "
                 "most, {from} to {to}.")));

}  // namespace aerostat::scene::detail
