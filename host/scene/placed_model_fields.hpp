#pragma once

#include "scene/field.hpp"
#include "scene/geo_point_fields.hpp"
#include "scene/placed_model.hpp"

/// Models from files.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<PlacedArea> = table(
    "Area over which the instances of a model are strewn, and the rules by which they stand. The "
    "position of the model is the middle of the area. Where the rules leave no room, there are "
    "fewer instances.",
    field("size_m", &PlacedArea::size_m,
          number(0, 1000000, "Width of the area along x and along z in metres.")),
    field("seed", &PlacedArea::seed,
          number(0, 4294967295, "Seed of places, sizes and headings, {from} to {to}.")),
    field("on", &PlacedArea::on,
          word("Where instances stand: on land (the default), on water, where they float at its "
               "level, or anywhere on the ground, wet or dry.")),
    field("slope_deg", &PlacedArea::slope_deg,
          number(0, 90, "Least and greatest slope of the ground in degrees, each {from} to {to}.")),
    field("heights_m", &PlacedArea::heights_m,
          number(-12000, 12000,
                 "Least and greatest height of the ground above the sea in metres.")),
    field("cover", &PlacedArea::cover,
          list(9,
               "Classes of land cover on which instances stand, at most {to}. By default, they "
               "stand on any. Where the scene has no land cover, the rule leaves no room.")),
    field("apart_m", &PlacedArea::apart_m,
          number(0, 10000,
                 "Least distance from the middle of an instance to those of all other models in "
                 "metres, {from} to {to}.")),
    field("sizes", &PlacedArea::sizes,
          number(0.001, 1000,
                 "Least and greatest factor on the size of the model, each {from} to {to}.")),
    field("turned", &PlacedArea::turned,
          truth("Whether each instance has a heading of its own (the default). Otherwise, all have "
                "that of the model.")));

template <>
inline constexpr auto kTable<PlacedModel> = table(
    "Model from a file that stands in the landscape.",
    field("file", &PlacedModel::file,
          text("Name of a glTF (.glb, .gltf), OBJ, PLY or STL file, relative to the folder of the "
               "scene file.")
              .required()),
    field("position", &PlacedModel::position,
          place("Place of the foot, which is the lowest point of the model, in the middle of its "
                "bounding box, the origin by default.")
              .slider(EditGroup::model, "East", -2000, 2000, 1)
              .slider(EditGroup::model, "Height", -50, 500, 1)
              .slider(EditGroup::model, "South", -2000, 2000, 1)),
    field("height_above", &PlacedModel::height_above,
          word("Level from which the y of the position is measured: the sea, or the ground below "
               "the model (the default).")
              .words(2)
              .control(EditGroup::model, "Height counts from")),
    field("at", &PlacedModel::at),
    field("heading_deg", &PlacedModel::heading_deg,
          number(-360, 360,
                 "Rotation about the vertical axis in degrees, {from} to {to}, clockwise as seen "
                 "from above. At 0, the x of the file points to the east, and its z to the south.")
              .slider(EditGroup::model, "Heading", -180, 180)),
    field("scale", &PlacedModel::scale,
          number(0, 1e6, "Metres for each unit of the file, {from} to {to}, 1 by default.")
              .above()
              .slider(EditGroup::model, "Scale", 0.001, 1000, 3, Scale::logarithmic)),
    field("height_m", &PlacedModel::height_m,
          number(0, 10000, "Height of the model in metres, {from} to {to}. It wins over scale.")
              .above()
              .slider(EditGroup::model, "Height of the model", 0.5, 100, 2, Scale::logarithmic)),
    field("up", &PlacedModel::up,
          word("Axis of the file that points up. It is always y in glTF, which is the default, and "
               "often z in files from CAD programs.")
              .control(EditGroup::model, "Upward axis")),
    field(
        "count", &PlacedModel::count,
        number(1, kMostInstances,
               "Number of instances, {from} to {to}. More than one are strewn over the area. There "
               "are at most {to} instances in all.")
            .slider(EditGroup::model, "Copies", 1, 1000, 0, Scale::logarithmic)),
    field("area", &PlacedModel::area));

}  // namespace aerostat::scene::detail
