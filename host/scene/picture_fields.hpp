#pragma once

#include "scene/field.hpp"
#include "scene/geo_point_fields.hpp"
#include "scene/picture.hpp"

/// The camera and the picture.
namespace aerostat::scene::detail {

/// The reach of a camera, in metres. It is a little more than that of a balloon, so that a view
/// from the basket of the farthest balloon is a scene, too.
inline constexpr double kEyeReach = 1.1e6;

template <>
inline constexpr auto kTable<Camera> = table(
    "The camera.",
    field("view", &Camera::view,
          word("Place where the defaults put the camera: outside the balloon or in its basket.")),
    field("position", &Camera::position,
          place("Position of the camera. If it is left out in the view from the basket, the camera "
                "stands in the basket at eye height.",
                kEyeReach)
              .boxes(EditGroup::camera, "Eye", 1)),
    field("target", &Camera::target,
          place("Point that is in the middle of the picture. If it is left out in the view from "
                "the basket, the camera looks straight ahead.",
                kEyeReach)
              .boxes(EditGroup::camera, "Looks at", 1)),
    field("height_above", &Camera::height_above,
          word("Level from which the y of position and target is measured: the sea, the ground "
               "below each of them, or the floor of the balloon's basket (the default).")
              .control(EditGroup::camera, "Heights count from")),
    field("at", &Camera::at), field("look_at", &Camera::look_at),
    field("up", &Camera::up,
          number(-1000, 1000,
                 "Direction that points upwards in the picture. Its length does not matter but "
                 "must not be 0. If the camera looks along it, y points upwards instead. In a view "
                 "straight down, north is at the top of the picture, and in a view straight up, "
                 "south is. Components are {from} to {to}.")
              .boxes(EditGroup::camera, "Upwards", 2)),
    field("lens", &Camera::lens,
          word("With pinhole, everything is sharp. With thin_lens, one distance is sharp. A "
               "panorama shows all directions, 360 degrees across and 180 degrees down. It suits a "
               "picture twice as wide as high, and only the azimuth of its target matters. With "
               "orthographic, parallel rays start at the plane through the position, and plants "
               "stand around the target.")
              .control(EditGroup::lens, "Lens")),
    field("fov_y_deg", &Camera::fov_y_deg,
          number(1, 170,
                 "Vertical angle of view of pinhole and thin_lens in degrees, {from} to {to}.")
              .slider(EditGroup::lens, "Angle of view", 8, 110, 1)),
    field(
        "f_number", &Camera::f_number,
        number(0.1, 1000,
               "F-number of thin_lens, {from} to {to}: its focal length divided by the diameter of "
               "its aperture. The focal length follows from fov_y_deg with a sensor 24 mm high.")
            .slider(EditGroup::lens, "F-number", 0.5, 22, 1, Scale::logarithmic)),
    field("aperture_m", &Camera::aperture_m,
          number(0, 1000,
                 "Diameter of the aperture of thin_lens in metres, {from} to {to}. If it is left "
                 "out, it follows from f_number.")
              .slider(EditGroup::camera, "Aperture", 0.001, 1, 3, Scale::logarithmic)),
    field("focus_m", &Camera::focus_m,
          number(0.01, 1000000,
                 "Distance along the axis at which thin_lens is in focus, in metres, {from} to "
                 "{to}. If it is left out, the target is in focus.")
              .slider(EditGroup::lens, "In focus at", 1, 5000, 1, Scale::logarithmic)),
    field("view_height_m", &Camera::view_height_m,
          number(0.001, 1000000,
                 "Height of what orthographic shows, from the bottom to the top of the picture, in "
                 "metres, {from} to {to}.")
              .slider(EditGroup::lens, "Height of parallel view", 10, 5000, 0,
                      Scale::logarithmic)));

template <>
inline constexpr auto kTable<Image> = table(
    "The picture.",
    field("width", &Image::width,
          number(1, 32768, "Width in pixels, {from} to {to}.")
              .slider(EditGroup::size, "Width", 160, 3840)
              .unit("px")),
    field("height", &Image::height,
          number(1, 32768, "Height in pixels, {from} to {to}.")
              .slider(EditGroup::size, "Height", 90, 2160)
              .unit("px")),
    field("spp", &Image::spp,
          number(1, 65536,
                 "Number of samples per pixel, {from} to {to}. If adaptive_threshold is above 0, "
                 "it is the largest number.")
              .slider(EditGroup::picture, "Samples per pixel", 1, 256, 0, Scale::logarithmic)),
    field("adaptive_threshold", &Image::adaptive_threshold,
          number(0, 1,
                 "Noise at which a pixel needs no more samples, as a share of the range from black "
                 "to white on a display, {from} (all pixels get spp samples) to {to}. It is "
                 "estimated from 16 samples on.")
              .slider(EditGroup::sampling, "Noise threshold", 0, 0.1, 4)),
    field("seed", &Image::seed,
          number(0, 4294967295, "Seed of the samples, {from} to {to}.")
              .slider(EditGroup::sampling, "Seed of samples", 1, 1000)),
    field("filter", &Image::filter,
          word("Reconstruction filter of the pixels.").control(EditGroup::sampling, "Filter")),
    field("exposure_ev", &Image::exposure_ev,
          number(-30, 30,
                 "Exposure in stops, {from} to {to}. Each stop doubles the brightness. If it is "
                 "left out, it is metered in the picture, and dusk and night stay dark.")
              .slider(EditGroup::development, "Exposure", -6, 6, 2)),
    field("white_balance_k", &Image::white_balance_k,
          number(1700, 25000,
                 "Colour temperature in kelvins of the light that looks white in the picture, "
                 "{from} to {to}. The value 6504 changes nothing. If it is left out, it goes half "
                 "of the way to the daylight of the scene.")
              .slider(EditGroup::development, "White balance", 2500, 12000, 0, Scale::logarithmic)),
    field("vignette", &Image::vignette,
          number(0, 0.9,
                 "Share of the light that is lost in the corners of the picture, {from} (none) to "
                 "{to}. The loss grows by the fourth power of a cosine.")
              .slider(EditGroup::development, "Vignette", 0, 0.9, 2)),
    field("glare", &Image::glare,
          number(0, 1,
                 "Strength of the glare, {from} (none) to {to}: the light that a lens scatters "
                 "around what is far brighter than white, such as the sun. A part of a picture "
                 "has the glare of its own light alone, and an EXR file has none.")
              .slider(EditGroup::development, "Glare", 0, 1, 2)));

}  // namespace aerostat::scene::detail
