#pragma once

#include "scene/field.hpp"
#include "scene/scene.hpp"

/// Balloons and materials.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<Balloon> = table(
    "A hot-air balloon. All that are there share the ids of their parts in an EXR.",
    field("enabled", &Balloon::enabled,
          truth("Whether there is a balloon.").control(EditGroup::balloon, "Present")),
    field("position", &Balloon::position,
          place("Centre of the basket's floor.")
              .slider(EditGroup::balloon, "East", -2000, 2000, 1)
              .slider(EditGroup::balloon, "Height", 0, 1500, 1)
              .slider(EditGroup::balloon, "South", -2000, 2000, 1)),
    field("height_above", &Balloon::height_above,
          word("What the position's y counts from: the sea (absolute) or the ground below (the "
               "default).")
              .words(2)
              .control(EditGroup::balloon, "Height counts from")),
    field("diameter_m", &Balloon::diameter_m,
          number(2, 200, "Largest diameter of the envelope in metres, {from} to {to}.")
              .slider(EditGroup::balloon, "Diameter", 10, 40, 1)),
    field("heading_deg", &Balloon::heading_deg,
          number(-360, 360, "Turn of the whole balloon about its axis in degrees, {from} to {to}.")
              .slider(EditGroup::balloon, "Heading", -180, 180)),
    field("gores", &Balloon::gores,
          number(6, 128, "Number of the envelope's gores, {from} to {to}.")
              .slider(EditGroup::envelope, "Gores", 8, 48)),
    field(
        "burner", &Balloon::burner,
        number(
            0, 1,
            "How hard the burners fire, {from} (no flame) to {to}; their light fills the envelope.")
            .slider(EditGroup::balloon, "Burner", 0, 1, 2)),
    field("pattern", &Balloon::pattern,
          word("How the colours are laid over the envelope.")
              .control(EditGroup::envelope, "Pattern")),
    field(
        "palette", &Balloon::palette,
        word("Fabrics that go together. Left out, the biome chooses; further balloons take turns.")
            .control(EditGroup::envelope, "Palette")),
    field("colors", &Balloon::colors,
          colors(1, 64,
                 "Colours of the fabric in place of a palette's, {from} to {to} of them; the "
                 "pattern repeats them.",
                 "Albedo of one fabric.")
              .control(EditGroup::envelope, "Colours")));

template <>
inline constexpr auto kTable<Material> = table(
    "Phong coefficients of one object.",
    field("albedo", &Material::albedo,
          color("Factor of the object's own colours.").control(EditGroup::material, "Albedo")),
    field("ambient", &Material::ambient,
          number(0, 10, "Factor of the sky's light, {from} to {to}.")
              .slider(EditGroup::material, "Ambient", 0, 2, 2)),
    field("diffuse", &Material::diffuse,
          number(0, 10, "Factor of Lambert's term, {from} to {to}.")
              .slider(EditGroup::material, "Diffuse", 0, 2, 2)),
    field("specular", &Material::specular,
          number(0, 10, "Factor of the highlight, {from} to {to}.")
              .slider(EditGroup::material, "Specular", 0, 2, 2)),
    field("shininess", &Material::shininess,
          number(1, 10000, "Exponent of the highlight, {from} to {to}.")
              .slider(EditGroup::material, "Shininess", 1, 1000, 0, Scale::logarithmic)),
    field("translucency", &Material::translucency,
          number(0, 1, "Share of the light on the far side that shines through, {from} to {to}.")
              .slider(EditGroup::material, "Translucency", 0, 1, 2)),
    field("emission", &Material::emission,
          color("Light of its own, times the colour of the vertices.", 1000000)
              .boxes(EditGroup::material, "Emission", 2)));

}  // namespace aerostat::scene::detail
