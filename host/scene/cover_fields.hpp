#pragma once

#include "scene/field.hpp"
#include "scene/land.hpp"

/// Land cover.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<CoverCode> =
    table("Class of a code of land cover.",
          field("code", &CoverCode::code, number(-32768, 65535, "Code, {from} to {to}.")),
          field("class", &CoverCode::is, word("What the code stands for.")));

template <>
inline constexpr auto kTable<LandCover> = table(
    "Raster of land cover, whose codes say what grows and lies on the ground of a source: ESA "
    "WorldCover, NLCD, CORINE and others. Where it ends, the biome's rules decide.",
    field("source", &LandCover::source,
          text("Name of the raster, relative to the folder of the scene file. An empty name means "
               "that there is none.")),
    field("scheme", &LandCover::scheme,
          word("Meaning of the codes. auto (the default) goes by the codes that occur.")),
    field("crs", &LandCover::crs,
          text("Coordinate reference system of the raster, such as EPSG:5070, which wins over what "
               "the file says.")),
    field("classes", &LandCover::classes,
          list(256,
               "Classes of further codes, at most {to}, which win over those of the scheme.")));

}  // namespace aerostat::scene::detail
