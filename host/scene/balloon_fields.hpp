#pragma once

#include "scene/artwork.hpp"
#include "scene/balloon.hpp"
#include "scene/field.hpp"
#include "scene/geo_point_fields.hpp"
#include "scene/objects.hpp"

/// Balloons and materials.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<Artwork> = table(
    "Picture on the envelope. Heights count along the cloth from the mouth. Where the picture is "
    "transparent, the colours of the fabric show.",
    field("file", &Artwork::file,
          text("Name of a PNG, JPEG or SVG file, relative to the folder of the scene file.")
              .required()),
    field(
        "wrap", &Artwork::wrap,
        word("How the picture lies on the cloth: whole (the default) is stretched once around and "
             "from the mouth to the crown, band goes around between two heights, motif lies at "
             "a place in its own proportions, and gores was drawn on the template that the "
             "command artwork writes.")),
    field(
        "around_deg", &Artwork::around_deg,
        number(-360, 360,
               "Direction in which the middle of the picture lies, in degrees from the heading of "
               "the balloon, {from} to {to}, clockwise as seen from above. It does not turn a "
               "picture on the template.")),
    field("height_m", &Artwork::height_m,
          number(0, 1000,
                 "Height of the middle of a motif along the cloth in metres, {from} to {to}, that "
                 "of the widest place by default.")),
    field("width_m", &Artwork::width_m,
          number(0, 1000, "Width of a motif in metres, {from} to {to}, 0.4 diameters by default.")
              .above()),
    field("heights_m", &Artwork::heights_m,
          number(0, 1000,
                 "Heights of the lower and of the upper edge of a band along the cloth in metres, "
                 "each {from} to {to}. By default, the band is a fifth of the cloth high, with the "
                 "widest place in its middle.")),
    field(
        "repeat", &Artwork::repeat,
        number(1, 256,
               "Number of copies around the envelope, {from} to {to}. By default it is 1, but for "
               "a band, whose copies keep their proportions as nearly as they close.")));

template <>
inline constexpr auto kTable<EnvelopeModel> = table(
    "Envelope of a special shape: the surface of a model from a file is its cloth, in the colours "
    "of "
    "the model. Skirt, cables and basket hang below its lowest point, which is in the middle of "
    "its "
    "bounding box. It has no artwork.",
    field("file", &EnvelopeModel::file,
          text("Name of a glTF (.glb, .gltf), OBJ, PLY or STL file, relative to the folder of the "
               "scene file.")
              .required()),
    field("up", &EnvelopeModel::up, word("Axis of the file that points up, y by default.")),
    field("height_m", &EnvelopeModel::height_m,
          number(0, 200,
                 "Height of the envelope in metres, {from} to {to}, by default that of the usual "
                 "envelope of the balloon's diameter.")
              .above()),
    field("turn_deg", &EnvelopeModel::turn_deg,
          number(-360, 360,
                 "Rotation against the balloon in degrees, {from} to {to}, clockwise as seen from "
                 "above. At 0, the z of the file points backwards.")));

template <>
inline constexpr auto kTable<Balloon> = table(
    "A hot-air balloon. In an EXR file, all balloons have the same object ids for their parts.",
    field("enabled", &Balloon::enabled,
          truth("Whether there is a balloon.").control(EditGroup::balloon, "Present")),
    field("position", &Balloon::position,
          place("Centre of the floor of the basket.")
              .slider(EditGroup::balloon, "East", -2000, 2000, 1)
              .slider(EditGroup::balloon, "Height", 0, 1500, 1)
              .slider(EditGroup::balloon, "South", -2000, 2000, 1)),
    field("height_above", &Balloon::height_above,
          word("Level from which the y of the position is measured: the sea, or the ground below "
               "the balloon (the default).")
              .words(2)
              .control(EditGroup::balloon, "Height counts from")),
    field("at", &Balloon::at), field("track", &Balloon::track),
    field("diameter_m", &Balloon::diameter_m,
          number(2, 200, "Largest diameter of the envelope in metres, {from} to {to}.")
              .slider(EditGroup::balloon, "Diameter", 10, 40, 1)),
    field(
        "heading_deg", &Balloon::heading_deg,
        number(-360, 360,
               "Rotation of the whole balloon about its vertical axis in degrees, {from} to {to}.")
            .slider(EditGroup::balloon, "Heading", -180, 180)),
    field("gores", &Balloon::gores,
          number(6, 128, "Number of gores of the envelope, {from} to {to}.")
              .slider(EditGroup::envelope, "Gores", 8, 48)),
    field("burner", &Balloon::burner,
          number(
              0, 1,
              "Strength of the burners, {from} (no flame) to {to}. Their light fills the envelope.")
              .slider(EditGroup::balloon, "Burner", 0, 1, 2)),
    field("pattern", &Balloon::pattern,
          word("Arrangement of the colours on the envelope.")
              .control(EditGroup::envelope, "Pattern")),
    field("palette", &Balloon::palette,
          word("Set of fabric colours that go together. If it is left out, the biome chooses it, "
               "and further balloons use the sets in turn.")
              .control(EditGroup::envelope, "Palette")),
    field("colors", &Balloon::colors,
          colors(1, 64,
                 "Colours of the fabric, which replace those of the palette, {from} to {to} of "
                 "them. The pattern repeats them.",
                 "Albedo of one fabric.")
              .control(EditGroup::envelope, "Colours")),
    field("passengers", &Balloon::passengers,
          number(0, 3, "Number of people in the basket, {from} (nobody, the default) to {to}.")
              .slider(EditGroup::balloon, "Passengers", 0, 3)
              .none("nobody")),
    field("envelope", &Balloon::envelope),
    field("artwork", &Balloon::artwork,
          list(kMostArtwork,
               "Pictures on the envelope, at most {to}. Later ones lie over former ones.")));

template <>
inline constexpr auto kTable<Festival> = table(
    "Balloons that are made from a seed, after those of /balloons. Their places, sizes, patterns, "
    "palettes and flames differ.",
    field("count", &Festival::count,
          number(0, kMostFurtherBalloons,
                 "Number of balloons, {from} (none) to {to}. There are at most 33 balloons in all. "
                 "Where the area has no room for so many, there are fewer.")
              .slider(EditGroup::festival, "Balloons", 0, 32)),
    field("seed", &Festival::seed,
          number(0, 4294967295, "Seed of the balloons, {from} to {to}.")
              .dice(EditGroup::festival, "Seed of balloons")),
    field("center", &Festival::center,
          number(-1000000, 1000000, "Middle of the area above which they fly, [x, z] in metres.")
              .slider(EditGroup::festival, "Middle of balloons, east", -3000, 3000)
              .slider(EditGroup::festival, "Middle of balloons, south", -3000, 3000)),
    field("spread_m", &Festival::spread_m,
          number(0, 100000, "Half of the width of the area along x and along z in metres.")
              .slider(EditGroup::festival, "Spread, east to west", 0, 2000)
              .slider(EditGroup::festival, "Spread, north to south", 0, 2000)),
    field("lowest_m", &Festival::lowest_m,
          number(0, 10000,
                 "Height of the lowest basket above the ground in metres, {from} to {to}.")
              .slider(EditGroup::festival, "Lowest balloon", 0, 500)),
    field("highest_m", &Festival::highest_m,
          number(0, 10000,
                 "Height of the highest basket above the ground in metres, {from} to {to}.")
              .slider(EditGroup::festival, "Highest balloon", 0, 1000)),
    field("apart_m", &Festival::apart_m,
          number(0, 10000, "Least distance between two balloons in metres, {from} to {to}.")
              .slider(EditGroup::festival, "Distance of balloons", 20, 200)),
    field("burner", &Festival::burner,
          number(0, 1,
                 "Greatest strength of the burners, {from} to {to}. At a value above 0, two of "
                 "three balloons burn, each with at least half of this strength.")
              .slider(EditGroup::festival, "Burners of balloons", 0, 1, 2)));

template <>
inline constexpr auto kTable<Material> = table(
    "Phong coefficients of one material.",
    field("albedo", &Material::albedo,
          color("Factor on the colours of the object. For terrain and water, it is their colour if "
                "/surfaces is plain, and has no effect otherwise.")
              .control(EditGroup::material, "Albedo")),
    field("ambient", &Material::ambient,
          number(0, 10, "Factor on the light of the sky, {from} to {to}.")
              .slider(EditGroup::material, "Ambient", 0, 2, 2)),
    field("diffuse", &Material::diffuse,
          number(0, 10, "Factor on the diffuse reflection (Lambert's cosine), {from} to {to}.")
              .slider(EditGroup::material, "Diffuse", 0, 2, 2)),
    field("specular", &Material::specular,
          number(0, 10, "Factor on the specular highlight, {from} to {to}.")
              .slider(EditGroup::material, "Specular", 0, 2, 2)),
    field("shininess", &Material::shininess,
          number(1, 10000, "Exponent of the specular highlight, {from} to {to}.")
              .slider(EditGroup::material, "Shininess", 1, 1000, 0, Scale::logarithmic)),
    field("translucency", &Material::translucency,
          number(
              0, 1,
              "Share of the light on the far side that shines through the surface, {from} to {to}.")
              .slider(EditGroup::material, "Translucency", 0, 1, 2)),
    field("emission", &Material::emission,
          color("Light that the surface emits. It is multiplied by the colours of the vertices.",
                1000000)
              .boxes(EditGroup::material, "Emission", 2)));

}  // namespace aerostat::scene::detail
