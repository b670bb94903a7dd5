#pragma once

#include <string>

#include "scene/field.hpp"
#include "scene/geo_point_fields.hpp"
#include "scene/light.hpp"

/// The sun, lamps, sky and air.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<Sun> = table(
    "The sun. Its position is given by its direction, by its two angles, or by date, time, "
    "latitude and longitude.",
    field("direction", &Sun::direction,
          number(-1000000, 1000000,
                 "Direction towards the sun. Its length does not matter but must not be 0. "
                 "Components are {from} to {to}.")),
    only_read<double>("azimuth_deg", number(-360, 360,
                                            "Azimuth of the sun in degrees, {from} to {to}. North "
                                            "(-z) is 0, and east (+x) is 90.")),
    only_read<double>("elevation_deg",
                      number(-90, 90,
                             "Height of the sun above the horizon in degrees, {from} to {to}.")),
    only_read<std::string>(
        "date", word("Date for which the position of the sun is computed, such as 2024-06-21.")),
    only_read<std::string>(
        "time",
        word("Time for which the position of the sun is computed, such as 06:30 or 06:30:15. It is "
             "universal time unless an offset follows, as in 06:30+02:00.")),
    only_read<double>(
        "latitude_deg",
        number(-90, 90,
               "Latitude of the place in degrees, positive to the north, {from} to {to}.")),
    only_read<double>(
        "longitude_deg",
        number(-180, 180,
               "Longitude of the place in degrees, positive to the east, {from} to {to}.")),
    field("color", &Sun::color,
          color("Colour of the sunlight outside the atmosphere. The largest component should be 1.")
              .control(EditGroup::sun, "Colour")),
    field("irradiance", &Sun::irradiance,
          number(0, 1000,
                 "Irradiance of a plane that faces the sun outside the atmosphere, {from} to {to}.")
              .slider(EditGroup::sun, "Brightness", 0, 20, 1)),
    field("diameter_deg", &Sun::diameter_deg,
          number(0.01, 10,
                 "Angular diameter in degrees of the sun's disc, which makes the edges of shadows "
                 "soft, {from} to {to}. The irradiance does not depend on it.")
              .slider(EditGroup::sun, "Diameter", 0.1, 10, 2)),
    field("shadows", &Sun::shadows,
          truth("Whether the sun casts shadows.").control(EditGroup::sun, "Shadows")),
    field("soft_shadows", &Sun::soft_shadows,
          truth("Whether the shadows of the sun have soft edges, because the sun is a disc. If it "
                "is left out, the quality decides.")
              .control(EditGroup::sun, "Soft shadows")));

template <>
inline constexpr auto kTable<Moon> = table(
    "The moon. Its phase follows from where moon and sun stand. It lights the land when the sun is "
    "lower than 4 degrees below the horizon. If the sun is given by date, time and place, what is "
    "left out here is the real moon's.",
    field("enabled", &Moon::enabled,
          truth("Whether there is a moon.").control(EditGroup::night, "Moon")),
    field("azimuth_deg", &Moon::azimuth_deg,
          number(-360, 360,
                 "Azimuth of the moon in degrees, {from} to {to}. North (-z) is 0, and east (+x) "
                 "is 90.")
              .slider(EditGroup::night, "Direction of the moon", -180, 180)),
    field("elevation_deg", &Moon::elevation_deg,
          number(-90, 90, "Height of the moon above the horizon in degrees, {from} to {to}.")
              .slider(EditGroup::night, "Height of the moon", -10, 90, 1)),
    field("distance_km", &Moon::distance_km,
          number(100000, 1000000,
                 "Distance of the moon in kilometres, {from} to {to}. It sets the size and the "
                 "brightness of the disc.")
              .slider(EditGroup::night, "Distance of the moon", 350000, 410000)
              .unit("km")));

template <>
inline constexpr auto kTable<Stars> = table(
    "The stars to magnitude 6 and the Milky Way. If the sun is given by date, time and place, what "
    "is left out here follows from them.",
    field("enabled", &Stars::enabled,
          truth("Whether stars shine at night.").control(EditGroup::night, "Stars")),
    field("latitude_deg", &Stars::latitude_deg,
          number(-90, 90,
                 "Latitude of the place in degrees, positive to the north, {from} to {to}. The "
                 "pole stands as high.")
              .slider(EditGroup::night, "Latitude", -90, 90, 1)),
    field("sidereal_deg", &Stars::sidereal_deg,
          number(-360, 360,
                 "Local sidereal time in degrees, {from} to {to}: the right ascension of the stars "
                 "that stand due south.")
              .slider(EditGroup::night, "Turn of the stars", 0, 360)),
    field("year", &Stars::year,
          number(1900, 2100, "Year in whose frame the stars stand, {from} to {to} (precession).")),
    field("milky_way", &Stars::milky_way,
          number(0, 10, "Brightness of the Milky Way relative to the real one, {from} to {to}.")
              .slider(EditGroup::night, "Milky Way", 0, 4, 1)));

template <>
inline constexpr auto kTable<PointLight> = table(
    "A point light.",
    field("position", &PointLight::position,
          place("Position of the light. Each light needs either this or a place on the Earth.")
              .boxes(EditGroup::lamps, "Place", 1)),
    field("height_above", &PointLight::height_above,
          word("Level from which the y of the position is measured: the sea (the default), or "
               "the ground below the light. The height of a place on the Earth is measured "
               "from the ground by default.")
              .words(2)
              .control(EditGroup::lamps, "Heights count from")),
    field("at", &PointLight::at),
    field("color", &PointLight::color,
          color("Colour of the light.").control(EditGroup::lamps, "Colour")),
    field("intensity", &PointLight::intensity,
          number(0, 1000000000,
                 "Irradiance times the square of the distance in metres, {from} to {to}.")
              .slider(EditGroup::lamps, "Intensity", 1, 1000000, 0, Scale::logarithmic)),
    field("shadows", &PointLight::shadows,
          truth("Whether the light casts shadows.").control(EditGroup::lamps, "Shadows")));

template <>
inline constexpr auto kTable<Cumulus> = table(
    "Cumulus clouds with flat bases. They cast shadows on the land.",
    field("cover", &Cumulus::cover,
          number(0, 1,
                 "Share of the sky straight above that the clouds cover, {from} (none) to {to}.")
              .slider(EditGroup::clouds, "Cumulus clouds", 0, 1, 2)),
    field("base_m", &Cumulus::base_m,
          number(0, 20000,
                 "Height of the bases of the clouds above the sea in metres, {from} to {to}.")
              .slider(EditGroup::clouds, "Base of the clouds", 200, 5000)),
    field("thickness_m", &Cumulus::thickness_m,
          number(10, 10000,
                 "Height of tall clouds from base to top in metres, {from} to {to}. Greater "
                 "heights than 1.5 times size_m are reduced to that.")
              .slider(EditGroup::clouds, "Thickness", 50, 3000, 0, Scale::logarithmic)),
    field("size_m", &Cumulus::size_m,
          number(10, 20000, "Width of a cloud in metres, {from} to {to}.")
              .slider(EditGroup::clouds, "Size of clouds", 100, 5000, 0, Scale::logarithmic)),
    field("seed", &Cumulus::seed,
          number(0, 4294967295, "Seed of the clouds, {from} to {to}. Each seed gives other clouds.")
              .slider(EditGroup::clouds, "Seed of clouds", 1, 1000)),
    field(
        "drift_m", &Cumulus::drift_m,
        number(-1e6, 1e6,
               "How far the wind has carried the clouds, [x, z] in metres, each {from} to {to}. A "
               "film moves it by its wind.")),
    field("rise_m", &Cumulus::rise_m,
          number(-1e6, 1e6,
                 "How far the bulges of the clouds have risen through them in metres, {from} to "
                 "{to}, which changes their shape. A film moves it.")));

template <>
inline constexpr auto kTable<Sky> = table(
    "Clouds, and the light that comes from the sky.",
    field("radiance", &Sky::radiance,
          color("Radiance of the sky in all directions, also below the horizon. If it is given, "
                "there are neither air, haze and fog nor clouds, and sunlight arrives as "
                "/sun/irradiance says. If it is left out, the sky follows from the air.",
                1000000)),
    field("cloud_cover", &Sky::cloud_cover,
          number(0, 1, "Share of the sky that thin, high clouds cover, {from} to {to}.")
              .slider(EditGroup::clouds, "High cloud", 0, 1, 2)),
    field("cloud_height_m", &Sky::cloud_height_m,
          number(100, 100000,
                 "Height of the thin, high clouds above the camera in metres, {from} to {to}.")
              .slider(EditGroup::clouds, "Height of high cloud", 2000, 15000)),
    field("cloud_drift_m", &Sky::cloud_drift_m,
          number(-1e6, 1e6,
                 "How far the wind has carried the thin, high clouds across the sky over the "
                 "camera, [x, z] in metres, each {from} to {to}. A film moves it by its wind, and "
                 "against its camera.")),
    field("cloud_bend_m", &Sky::cloud_bend_m,
          number(-1e6, 1e6,
                 "How far the pattern that bends the streaks of the thin, high clouds has gone "
                 "ahead of them in metres, {from} to {to}, which changes their shape. A film moves "
                 "it.")),
    field("ambient_occlusion", &Sky::ambient_occlusion,
          truth("Whether nearby surfaces block the light of the sky (ambient occlusion). If it is "
                "left out, the quality decides.")
              .control(EditGroup::sky_light, "Ambient occlusion")),
    field("occlusion_m", &Sky::occlusion_m,
          number(0.01, 100000,
                 "Distance in metres up to which surfaces block the light of the sky, {from} to "
                 "{to}. Farther surfaces block less of it.")
              .slider(EditGroup::sky_light, "Occlusion up to", 1, 2000, 0, Scale::logarithmic)),
    field("bounced_light", &Sky::bounced_light,
          truth("Whether surfaces that block the light of the sky reflect sunlight in its place.")
              .control(EditGroup::sky_light, "Bounced light")),
    field("cumulus", &Sky::cumulus));

template <>
inline constexpr auto kTable<Air> = table(
    "The gases of the air and the ground under it. The colours of sky, sunlight and distance "
    "follow from them.",
    field(
        "density", &Air::density,
        number(
            0, 10,
            "Density of the molecules relative to that of the Earth's air, {from} (none) to {to}.")
            .slider(EditGroup::air_in_detail, "Density of the air", 0, 4, 2)),
    field("ozone_du", &Air::ozone_du,
          number(0, 3000, "Amount of ozone in Dobson units, {from} to {to}.")
              .slider(EditGroup::air_in_detail, "Ozone", 0, 1000)),
    field(
        "ground_albedo", &Air::ground_albedo,
        color("Mean albedo of the land around. The air scatters the light that the land reflects.")
            .control(EditGroup::air_in_detail, "Albedo of the land")));

template <>
inline constexpr auto kTable<Haze> = table(
    "Droplets and dust in the air, which thin out with height. Together with the molecules, their "
    "extinction at sea level is 3.912 / visibility_m.",
    field("visibility_m", &Haze::visibility_m,
          number(10, 10000000, "Distance in metres at which contrast falls to 2 %, {from} to {to}.")
              .slider(EditGroup::air, "Visibility", 1000, 300000, 0, Scale::logarithmic)),
    field(
        "scale_height_m", &Haze::scale_height_m,
        number(1, 1000000,
               "Height in metres over which the density of the haze falls to 1/e, {from} to {to}.")
            .slider(EditGroup::air_in_detail, "Haze thins out over", 100, 5000, 0,
                    Scale::logarithmic)),
    field("angstrom", &Haze::angstrom,
          number(-1, 4,
                 "Angstrom exponent, {from} to {to}: the extinction is proportional to the "
                 "wavelength to the power of minus this value. It is 0 (grey) for fog, 0.3 for "
                 "dust and 1.3 for fine haze. If it is left out, it falls to 0 as the visibility "
                 "falls from 6 km to 500 m.")
              .slider(EditGroup::air_in_detail, "Colour of haze", 0, 3, 2)),
    field("asymmetry", &Haze::asymmetry,
          number(0, 0.95,
                 "Mean cosine of the angle by which haze scatters light, {from} (equal in all "
                 "directions) to {to} (forwards).")
              .slider(EditGroup::air_in_detail, "Forward scattering", 0, 0.95, 2)),
    field("albedo", &Haze::albedo,
          color("Share of the extinction that is scattering. The rest is absorption.", 1.0,
                " [red, green, blue], each {from} to {to}. If it is left out, it rises towards 1 "
                "as the visibility falls below 6 km.")
              .control(EditGroup::air_in_detail, "Albedo of haze")));

template <>
inline constexpr auto kTable<Fog> = table(
    "Fog that fills the valleys. It is equally dense up to its top.",
    field("enabled", &Fog::enabled,
          truth("Whether there is fog.").control(EditGroup::air, "Valley fog")),
    field(
        "visibility_m", &Fog::visibility_m,
        number(10, 1000000,
               "Distance in metres at which contrast inside the fog falls to 2 %, {from} to {to}.")
            .slider(EditGroup::air, "Visibility in the fog", 20, 5000, 0, Scale::logarithmic)),
    field("top_m", &Fog::top_m,
          number(-100000, 100000,
                 "Mean height of the top of the fog above the sea in metres, {from} to {to}.")
              .slider(EditGroup::air, "Top of the fog", -200, 2000)),
    field("softness_m", &Fog::softness_m,
          number(1, 10000,
                 "Height in metres over which the fog thins out at its top, {from} to {to}.")
              .slider(EditGroup::air_in_detail, "Fog thins out over", 1, 300, 0,
                      Scale::logarithmic)),
    field("billow_m", &Fog::billow_m,
          number(0, 10000,
                 "Height of the waves at the top of the fog in metres, {from} (level) to {to}.")
              .slider(EditGroup::air_in_detail, "Waves on the fog, height", 0, 300)),
    field("billow_width_m", &Fog::billow_width_m,
          number(10, 100000, "Length of the waves at the top of the fog in metres, {from} to {to}.")
              .slider(EditGroup::air_in_detail, "Waves on the fog, length", 50, 5000, 0,
                      Scale::logarithmic)));

}  // namespace aerostat::scene::detail
