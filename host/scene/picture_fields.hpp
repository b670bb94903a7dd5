#pragma once

#include "scene/field.hpp"
#include "scene/scene.hpp"

/// The camera and the picture.
namespace aerostat::scene::detail {

/// The reach of a camera, in metres. It is a little more than that of a balloon, so that a view
/// from the basket of the farthest balloon is a scene, too.
inline constexpr double kEyeReach = 1.1e6;

template <>
inline constexpr auto kTable<Camera> = table(
    "The eye.",
    field("view", &Camera::view,
          word("Where the defaults put the eye: outside the balloon or in its basket.")),
    field("position", &Camera::position,
          place("Where the eye is. In the basket view, left out, it stands inside at eye height.",
                kEyeReach)
              .boxes(EditGroup::camera, "Eye", 1)),
    field("target", &Camera::target,
          place("A point in the middle of the picture. In the basket view, left out, the eye looks "
                "straight ahead.",
                kEyeReach)
              .boxes(EditGroup::camera, "Looks at", 1)),
    field("height_above", &Camera::height_above,
          word("What the y of position and target counts from: the sea (absolute), the ground "
               "below each, or the floor of the balloon's basket (the default).")
              .control(EditGroup::camera, "Heights count from")),
    field("up", &Camera::up,
          number(-1000, 1000,
                 "Direction that is upright in the picture; its length does not matter, but must "
                 "not be 0. A view along it has y upright; a view straight down has north at the "
                 "top of the picture, one straight up has south there. Components {from} to {to}.")
              .boxes(EditGroup::camera, "Upright", 2)),
    field("lens", &Camera::lens,
          word("pinhole: all is sharp. thin_lens: sharp at one depth only. panorama: all "
               "directions, 360 degrees across and 180 down, best in a picture twice as wide as "
               "high; of the target only the azimuth counts. orthographic: parallel rays from the "
               "plane through the position, plants stand around the target.")
              .control(EditGroup::lens, "Lens")),
    field("fov_y_deg", &Camera::fov_y_deg,
          number(1, 170,
                 "Vertical angle of view in degrees of pinhole and thin_lens, {from} to {to}.")
              .slider(EditGroup::lens, "Angle of view", 8, 110, 1)),
    field("f_number", &Camera::f_number,
          number(0.1, 1000,
                 "Of thin_lens: its focal length, as fov_y_deg asks of it before a sensor 24 mm "
                 "high, over its aperture, {from} to {to}.")
              .slider(EditGroup::lens, "F-number", 0.5, 22, 1, Scale::logarithmic)),
    field("aperture_m", &Camera::aperture_m,
          number(0, 1000,
                 "Of thin_lens: diameter of the aperture in metres, {from} to {to}; left out, "
                 "f_number says it.")
              .slider(EditGroup::camera, "Aperture", 0.001, 1, 3, Scale::logarithmic)),
    field("focus_m", &Camera::focus_m,
          number(0.01, 1000000,
                 "Of thin_lens: distance of the plane that is sharp, in metres along the axis, "
                 "{from} to {to}; left out, the target is sharp.")
              .slider(EditGroup::lens, "Sharp at", 1, 5000, 1, Scale::logarithmic)),
    field("view_height_m", &Camera::view_height_m,
          number(0.001, 1000000,
                 "Of orthographic: metres from the foot to the top of the picture, {from} to {to}.")
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
                 "Samples per pixel, at most if adaptive_threshold is above 0, {from} to {to}.")
              .slider(EditGroup::picture, "Samples a pixel", 1, 256, 0, Scale::logarithmic)),
    field("adaptive_threshold", &Image::adaptive_threshold,
          number(0, 1,
                 "From 16 samples on, a pixel whose noise is estimated at less than this share of "
                 "the way from black to white on a display has enough of them, {from} (all get "
                 "spp) to {to}.")
              .slider(EditGroup::sampling, "Enough at a noise of", 0, 0.1, 4)),
    field("seed", &Image::seed,
          number(0, 4294967295, "Seed of the samples, {from} to {to}.")
              .slider(EditGroup::sampling, "Seed of samples", 1, 1000)),
    field("filter", &Image::filter,
          word("Reconstruction filter.").control(EditGroup::sampling, "Filter")),
    field("exposure_ev", &Image::exposure_ev,
          number(-30, 30,
                 "Exposure in stops: each doubles the brightness, {from} to {to}. Left out, it "
                 "follows from the picture, and dusk and night stay dark.")
              .slider(EditGroup::development, "Exposure", -6, 6, 2)),
    field(
        "white_balance_k", &Image::white_balance_k,
        number(
            1700, 25000,
            "Colour temperature in kelvins of the light that comes out white, {from} to {to}; 6504 "
            "changes nothing. Left out, it goes half of the way to the daylight of the scene.")
            .slider(EditGroup::development, "White balance", 2500, 12000, 0, Scale::logarithmic)),
    field("vignette", &Image::vignette,
          number(0, 0.9,
                 "Share of the light that is lost in the corners of the picture, by the fourth "
                 "power of a cosine, {from} (none) to {to}.")
              .slider(EditGroup::development, "Vignette", 0, 0.9, 2)));

}  // namespace aerostat::scene::detail
