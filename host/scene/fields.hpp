#pragma once

#include "scene/balloon_fields.hpp"
#include "scene/film_fields.hpp"
#include "scene/land_fields.hpp"
#include "scene/light_fields.hpp"
#include "scene/picture_fields.hpp"
#include "scene/placed_model_fields.hpp"
#include "scene/scene.hpp"

/// The tables of all fields. Schema, reader, writer, the manual's reference and the window's
/// controls follow from them.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<Scene> = table(
    "A scene of the renderer aerostat. Lengths are in metres and angles in degrees, and y points "
    "upwards. Azimuth 0 is north (-z), and azimuth 90 is east (+x). Values that a file leaves out "
    "come from its biome and view.",
    field("biome", &Scene::biome,
          object("Kind of landscape, which sets the defaults of terrain, colours, light, sky, air "
                 "and balloons. It is either a name or an object.",
                 "Name of the biome. Everything else has its default.")),
    field("terrain", &Scene::terrain), field("vegetation", &Scene::vegetation),
    field("balloon", &Scene::balloon),
    field("balloons", &Scene::balloons,
          list(kMostFurtherBalloons,
               "Further balloons, at most {to}. Each is built with as much detail as its size in "
               "the picture requires.")),
    field("festival", &Scene::festival),
    field("objects", &Scene::objects,
          list(kMostObjects,
               "Models from files that stand in the landscape, at most {to}. A file that is named "
               "more than once is read once.")),
    field("camera", &Scene::camera),
    field(
        "mood", &Scene::mood,
        word("Time of day or weather. It sets defaults of sun, moon, air, clouds and film that go "
             "before those of the biome. Values that a file gives win over it. none (the "
             "default) leaves all as the biome has it.")
            .control(EditGroup::mood, "Mood")),
    field("sun", &Scene::sun), field("moon", &Scene::moon), field("stars", &Scene::stars),
    field("lights", &Scene::lights, list(16, "Point lights, at most {to}.")),
    field("sky", &Scene::sky), field("air", &Scene::air), field("haze", &Scene::haze),
    field("fog", &Scene::fog),
    field("materials", &Scene::materials,
          object("Phong coefficients of each material. Ground and sea have their colours from the "
                 "biome unless surfaces is plain.")),
    field("surfaces", &Scene::surfaces,
          word("Look of all surfaces. full (the default) has textures, bumps, gloss, waves and "
               "translucent cloth. plain has none of them: each surface reflects light evenly in "
               "all directions (Lambert), and nothing shines. Its albedo is that of its material, "
               "multiplied by the colours of balloon, plants and stones. Such pictures can be "
               "compared with those of other renderers.")
              .control(EditGroup::picture, "Surfaces")),
    field("shading", &Scene::shading,
          word("Shading over a triangle: flat is the same everywhere, gouraud interpolates "
               "colours, and phong (the default) interpolates normals.")
              .control(EditGroup::picture, "Shading")),
    field("light", &Scene::light,
          word("How light is found. local (the default) adds up what each surface gets from sun, "
               "sky and lamps. path follows light from surface to surface, so that surfaces light "
               "each other, and takes longer.")
              .control(EditGroup::picture, "Light")),
    field(
        "bounces", &Scene::bounces,
        number(0, 64,
               "How often a path of light may go on from one surface to another, {from} (surfaces "
               "get light straight from sun, sky and lamps alone) to {to}.")
            .slider(EditGroup::picture, "Bounces of light", 0, 16)),
    field("quality", &Scene::quality,
          word("Sets /image/spp, /image/adaptive_threshold, /sun/soft_shadows and "
               "/sky/ambient_occlusion where the scene leaves them out. Their values are 1, 0, "
               "false, false with draft, 4, 0, true, true with standard (the default), and 256, "
               "0.008, true, true with final.")
              .control(EditGroup::picture, "Quality")),
    field("image", &Scene::image), field("film", &Scene::film));

}  // namespace aerostat::scene::detail
