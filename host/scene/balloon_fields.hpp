#pragma once

#include "scene/balloon.hpp"
#include "scene/field.hpp"
#include "scene/objects.hpp"

/// Balloons and materials.
namespace aerostat::scene::detail {

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
              .control(EditGroup::envelope, "Colours")));

template <>
inline constexpr auto kTable<Material> = table(
    "Phong coefficients of one material.",
    field("albedo", &Material::albedo,
          color("Factor on the colours of the object.").control(EditGroup::material, "Albedo")),
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
