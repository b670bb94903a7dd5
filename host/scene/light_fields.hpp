#pragma once

#include <string>

#include "scene/field.hpp"
#include "scene/scene.hpp"

/// The sun, lamps, sky and air.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<Sun> = table(
    "The sun. Give its direction, or the two angles, or date, time, latitude and longitude.",
    field("direction", &Sun::direction,
          number(-1000000, 1000000,
                 "Direction towards the sun; any length but 0. Components {from} to {to}.")),
    only_read<double>(
        "azimuth_deg",
        number(-360, 360, "Azimuth in degrees, 0 = north (-z), 90 = east (+x), {from} to {to}.")),
    only_read<double>("elevation_deg",
                      number(-90, 90, "Height above the horizon in degrees, {from} to {to}.")),
    only_read<std::string>("date", word("Day at which it stands where it stands, as 2024-06-21.")),
    only_read<std::string>("time", word("Time of that day, as 06:30 or 06:30:15, universal time "
                                        "unless an offset follows: 06:30+02:00.")),
    only_read<double>("latitude_deg",
                      number(-90, 90,
                             "Latitude of the place in degrees, north positive, {from} to {to}.")),
    only_read<double>("longitude_deg",
                      number(-180, 180,
                             "Longitude of the place in degrees, east positive, {from} to {to}.")),
    field("color", &Sun::color,
          color("Colour of the light outside the air; the largest component should be 1.")
              .control(EditGroup::sun, "Colour")),
    field("irradiance", &Sun::irradiance,
          number(0, 1000,
                 "Irradiance of a plane that faces the sun outside the air, {from} to {to}.")
              .slider(EditGroup::sun, "Brightness", 0, 20, 1)),
    field("shadows", &Sun::shadows,
          truth("Whether it casts shadows.").control(EditGroup::sun, "Shadows")),
    field("soft_shadows", &Sun::soft_shadows,
          truth("Whether its shadows have the soft edges of its disc. Left out, the quality says.")
              .control(EditGroup::sun, "Soft shadows")));

template <>
inline constexpr auto kTable<PointLight> =
    table("A point light.",
          field("position", &PointLight::position,
                place("Where it is, heights above the sea.")
                    .boxes(EditGroup::lamps, "Place", 1)
                    .required()),
          field("color", &PointLight::color,
                color("Colour of the light.").control(EditGroup::lamps, "Colour")),
          field("intensity", &PointLight::intensity,
                number(0, 1000000000,
                       "Irradiance times the square of the distance in metres, {from} to {to}.")
                    .slider(EditGroup::lamps, "Intensity", 1, 1000000, 0, Scale::logarithmic)),
          field("shadows", &PointLight::shadows,
                truth("Whether it casts shadows.").control(EditGroup::lamps, "Shadows")));

template <>
inline constexpr auto kTable<Cumulus> = table(
    "Heaped clouds over flat bases. Their shadows fall on the land.",
    field("cover", &Cumulus::cover,
          number(0, 1, "Share of the sky straight above that they cover, {from} (none) to {to}.")
              .slider(EditGroup::clouds, "Heaped clouds", 0, 1, 2)),
    field("base_m", &Cumulus::base_m,
          number(0, 20000, "Height of their bases above the sea in metres, {from} to {to}.")
              .slider(EditGroup::clouds, "Base of the clouds", 200, 5000)),
    field("thickness_m", &Cumulus::thickness_m,
          number(10, 10000,
                 "From the bases to high tops in metres, {from} to {to}; at most 1.5 times size_m "
                 "counts.")
              .slider(EditGroup::clouds, "Thickness", 50, 3000, 0, Scale::logarithmic)),
    field("size_m", &Cumulus::size_m,
          number(10, 20000, "How wide a cloud is, in metres, {from} to {to}.")
              .slider(EditGroup::clouds, "Size of clouds", 100, 5000, 0, Scale::logarithmic)),
    field("seed", &Cumulus::seed,
          number(0, 4294967295, "Another number, other clouds, {from} to {to}.")
              .slider(EditGroup::clouds, "Seed of clouds", 1, 1000)));

template <>
inline constexpr auto kTable<Sky> =
    table("What is in the sky beside sun and air.",
          field("cloud_cover", &Sky::cloud_cover,
                number(0, 1, "Share of the sky that thin high cloud covers, {from} to {to}.")
                    .slider(EditGroup::clouds, "High cloud", 0, 1, 2)),
          field("cloud_height_m", &Sky::cloud_height_m,
                number(100, 100000, "Height of the clouds above the eye in metres, {from} to {to}.")
                    .slider(EditGroup::clouds, "Height of high cloud", 2000, 15000)),
          field("ambient_occlusion", &Sky::ambient_occlusion,
                truth("Whether what is near keeps the sky's light off. Left out, the quality says.")
                    .control(EditGroup::sky_light, "Dimmed by what is near")),
          field("occlusion_m", &Sky::occlusion_m,
                number(0.01, 100000,
                       "How far away it may be for that, in metres, {from} to {to}; the farther, "
                       "the less it counts.")
                    .slider(EditGroup::sky_light, "As far as", 1, 2000, 0, Scale::logarithmic)),
          field("bounced_light", &Sky::bounced_light,
                truth("Whether what keeps the sky's light off sends sunlight of its own instead.")
                    .control(EditGroup::sky_light, "Bounced light")),
          field("cumulus", &Sky::cumulus));

template <>
inline constexpr auto kTable<Air> = table(
    "The gases of the air and the ground under it; sky, sunlight and distance take their colours "
    "from them.",
    field("density", &Air::density,
          number(0, 10, "Of the molecules, relative to the Earth's, {from} (none) to {to}.")
              .slider(EditGroup::air_in_detail, "Density of the air", 0, 4, 2)),
    field("ozone_du", &Air::ozone_du,
          number(0, 3000, "Ozone in Dobson units, {from} to {to}.")
              .slider(EditGroup::air_in_detail, "Ozone", 0, 1000)),
    field("ground_albedo", &Air::ground_albedo,
          color("Albedo of the land around, whose light the air sends back.")
              .control(EditGroup::air_in_detail, "Land around")));

template <>
inline constexpr auto kTable<Haze> = table(
    "Droplets and dust in the air: with the molecules, extinction 3.912 / visibility at sea level, "
    "falling off with height.",
    field("visibility_m", &Haze::visibility_m,
          number(10, 10000000, "Distance in metres at which contrast falls to 2 %, {from} to {to}.")
              .slider(EditGroup::air, "Visibility", 1000, 300000, 0, Scale::logarithmic)),
    field("scale_height_m", &Haze::scale_height_m,
          number(1, 1000000, "Height in metres over which the haze falls to 1/e, {from} to {to}.")
              .slider(EditGroup::air_in_detail, "Haze thins out over", 100, 5000, 0,
                      Scale::logarithmic)),
    field("angstrom", &Haze::angstrom,
          number(-1, 4,
                 "Extinction goes with the wavelength to the power of minus this, {from} to {to}: "
                 "0 (grey) for fog, 0.3 for dust, 1.3 for fine haze. Left out, it falls to 0 as "
                 "the visibility falls from 6 km to 500 m.")
              .slider(EditGroup::air_in_detail, "Colour of haze", 0, 3, 2)),
    field("asymmetry", &Haze::asymmetry,
          number(0, 0.95,
                 "Mean cosine of the angle by which light is deflected, {from} (evenly) to {to} "
                 "(forwards).")
              .slider(EditGroup::air_in_detail, "Forward scattering", 0, 0.95, 2)),
    field("albedo", &Haze::albedo,
          color("Share of the extinction that is scattering, the rest is absorbed.", 1.0,
                " [red, green, blue], each {from} to {to}. Left out, it grows towards 1 as the "
                "visibility falls below 6 km.")
              .control(EditGroup::air_in_detail, "Haze scatters")));

template <>
inline constexpr auto kTable<Fog> = table(
    "Fog that fills the valleys, even up to its top.",
    field("enabled", &Fog::enabled,
          truth("Whether there is fog.").control(EditGroup::air, "Valley fog")),
    field("visibility_m", &Fog::visibility_m,
          number(10, 1000000,
                 "Distance in metres at which contrast inside it falls to 2 %, {from} to {to}.")
              .slider(EditGroup::air, "Sight in the fog", 20, 5000, 0, Scale::logarithmic)),
    field("top_m", &Fog::top_m,
          number(-100000, 100000, "Mean height of its top above the sea in metres, {from} to {to}.")
              .slider(EditGroup::air, "Top of the fog", -200, 2000)),
    field("softness_m", &Fog::softness_m,
          number(1, 10000, "Height in metres over which it thins out, {from} to {to}.")
              .slider(EditGroup::air_in_detail, "Fog ends over", 1, 300, 0, Scale::logarithmic)),
    field("billow_m", &Fog::billow_m,
          number(0, 10000, "How far its top goes up and down, in metres, {from} (level) to {to}.")
              .slider(EditGroup::air_in_detail, "Fog goes up and down", 0, 300)),
    field("billow_width_m", &Fog::billow_width_m,
          number(10, 100000, "Wavelength of its top's ups and downs in metres, {from} to {to}.")
              .slider(EditGroup::air_in_detail, "Width of that", 50, 5000, 0, Scale::logarithmic)));

}  // namespace aerostat::scene::detail
