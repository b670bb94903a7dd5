#pragma once

#include "scene/balloon_fields.hpp"
#include "scene/land_fields.hpp"
#include "scene/light_fields.hpp"
#include "scene/picture_fields.hpp"

/// The tables of all fields. Schema, reader, writer, the manual's reference and the window's
/// controls follow from them.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<Scene> = table(
    "A scene of the renderer aerostat. Lengths in metres, angles in degrees, y up, azimuth 0 = "
    "north (-z), 90 = east (+x). Whatever a file leaves out comes from its biome and view.",
    field("biome", &Scene::biome,
          object("The switch that brings terrain shape, colours, light, sky, air and balloon "
                 "colours. Either its name alone or an object.",
                 "The biome's name alone; everything else by default.")),
    field("terrain", &Scene::terrain), field("vegetation", &Scene::vegetation),
    field("balloon", &Scene::balloon),
    field("balloons", &Scene::balloons,
          list(32,
               "Further balloons, at most {to}; each is built as fine as its size in the picture "
               "asks for.")),
    field("camera", &Scene::camera), field("sun", &Scene::sun),
    field("lights", &Scene::lights, list(16, "Point lights, at most {to}.")),
    field("sky", &Scene::sky), field("air", &Scene::air), field("haze", &Scene::haze),
    field("fog", &Scene::fog),
    field(
        "materials", &Scene::materials,
        object("Phong coefficients per object; ground and sea take their colours from the biome.")),
    field("shading", &Scene::shading,
          word("How normals and colours vary over a triangle: not at all, colours interpolated, or "
               "normals interpolated (the default).")
              .control(EditGroup::picture, "Shading")),
    field("quality", &Scene::quality,
          word("Sets /image/spp, /image/adaptive_threshold, /sun/soft_shadows and "
               "/sky/ambient_occlusion where the scene leaves them out: draft is 1, 0, false, "
               "false; standard (the default) 4, 0, true, true; final 256, 0.008, true, true.")
              .control(EditGroup::picture, "Quality")),
    field("image", &Scene::image));

}  // namespace aerostat::scene::detail
