#pragma once

#include "scene/field.hpp"
#include "scene/geo_point_fields.hpp"
#include "scene/placed_model.hpp"

/// Models from files.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<PlacedModel> = table(
    "Model from a file that stands in the landscape.",
    field("file", &PlacedModel::file,
          text("Name of a glTF (.glb, .gltf), OBJ, PLY or STL file, relative to the folder of the "
               "scene file.")
              .required()),
    field("position", &PlacedModel::position,
          place("Place of the foot, which is the lowest point of the model, in the middle of its "
                "bounding box, the origin by default.")),
    field("height_above", &PlacedModel::height_above,
          word("Level from which the y of the position is measured: the sea, or the ground below "
               "the model (the default).")
              .words(2)),
    field("at", &PlacedModel::at),
    field(
        "heading_deg", &PlacedModel::heading_deg,
        number(-360, 360,
               "Rotation about the vertical axis in degrees, {from} to {to}, clockwise as seen "
               "from above. At 0, the x of the file points to the east, and its z to the south.")),
    field(
        "scale", &PlacedModel::scale,
        number(0, 1e6, "Metres for each unit of the file, {from} to {to}, 1 by default.").above()),
    field("height_m", &PlacedModel::height_m,
          number(0, 10000, "Height of the model in metres, {from} to {to}. It wins over scale.")
              .above()),
    field("up", &PlacedModel::up,
          word("Axis of the file that points up. It is always y in glTF, which is the default, and "
               "often z in files from CAD programs.")));

}  // namespace aerostat::scene::detail
