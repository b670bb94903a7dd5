#pragma once

#include "scene/field.hpp"
#include "scene/film.hpp"

/// The film of a scene.
namespace aerostat::scene::detail {

/// The longest film, in seconds: a day.
inline constexpr double kLongestFilm_s = 86400.0;
/// The most tracks of keys, and the most keys or points of one list.
inline constexpr int kMostKeyTracks = 64, kMostKeys = 1000, kMostWindLayers = 32;

template <>
inline constexpr auto kTable<Key> =
    table("A key: the value at a time.",
          field("time_s", &Key::time_s,
                number(0, kLongestFilm_s,
                       "Time from the beginning of the film in seconds, {from} to {to}.")
                    .required()),
          field("is", &Key::is,
                text("The value at that time, in the form that the scene has it.").required()));

template <>
inline constexpr auto kTable<KeyTrack> = table(
    "The keys of one value. Before the first key and after the last one, the value stays as they "
    "have it.",
    field("value", &KeyTrack::value,
          text("JSON pointer of the value that moves, such as /sun/elevation_deg: a number, an "
               "array of numbers, a word, or /sun/time. Angles that go full circle take the "
               "shorter way.")
              .required()),
    field("ease", &KeyTrack::ease,
          word("How the value goes from one key to the next: linear at an even rate, smooth (the "
               "default) slowly at both ends, and hold not at all until the next key. Words "
               "always hold.")),
    field("keys", &KeyTrack::keys,
          list(kMostKeys, "Keys with rising times, at most {to}.").required()));

template <>
inline constexpr auto kTable<WindLayer> = table(
    "The wind at a height.",
    field("height_m", &WindLayer::height_m,
          number(-1000, 100000, "Height above the sea in metres, {from} to {to}.")),
    field("speed_m_s", &WindLayer::speed_m_s,
          number(0, 200, "Speed of the air in metres per second, {from} to {to}.")),
    field(
        "from_deg", &WindLayer::from_deg,
        number(-360, 360,
               "Azimuth from which the wind comes in degrees, {from} to {to}: 270 is a west wind, "
               "which blows to the east.")));

template <>
inline constexpr auto kTable<PathPoint> = table(
    "A point of the camera's path.",
    field("position", &PathPoint::position,
          place("Position of the camera. Its height counts from the level that "
                "/camera/height_above names, as it is there when the film begins.")
              .required()),
    field("time_s", &PathPoint::time_s,
          number(0, kLongestFilm_s,
                 "Time in seconds at which the camera is there, {from} to {to}. If no point has "
                 "one, the points share the film's time evenly.")));

template <>
inline constexpr auto kTable<CameraMove> = table(
    "How the camera moves.",
    field("mode", &CameraMove::mode,
          word("scene (the default) leaves the camera where the scene and its keys put it. path "
               "flies through the points of path. orbit circles the balloon. chase follows the "
               "balloon from where the scene has the camera, softly. basket looks from the basket. "
               "ground stands on the ground below the scene's camera.")),
    field("look", &CameraMove::look,
          word("What the camera looks at: target is the scene's own, balloon the middle of the "
               "balloon, ahead where the camera goes. usual (the default) is the balloon with "
               "orbit, chase and ground, ahead with basket, and target with scene and path.")),
    field("path", &CameraMove::path,
          list(kMostKeys, "Points of a path, at most {to}; a smooth curve leads through them.")),
    field("constant_speed", &CameraMove::constant_speed,
          truth("Whether the camera flies along its path at an even speed, from the first time to "
                "the last. The times of the points between do not matter then.")),
    field("radius_m", &CameraMove::radius_m,
          number(0.1, 100000,
                 "Distance of an orbit from the balloon's axis in metres, {from} to {to}.")),
    field("height_m", &CameraMove::height_m,
          number(-10000, 100000,
                 "Height of an orbit above the floor of the basket in metres, {from} to {to}.")),
    field("from_deg", &CameraMove::from_deg,
          number(-360, 360,
                 "Azimuth in degrees, seen from the balloon, at which an orbit begins, {from} to "
                 "{to}.")),
    field("turn_deg_s", &CameraMove::turn_deg_s,
          number(-360, 360,
                 "Turn of an orbit in degrees per second, {from} to {to}. Positive turns go from "
                 "north to east.")),
    field("lag_s", &CameraMove::lag_s,
          number(0, 60,
                 "Time in seconds by which a chase lags behind the balloon, {from} to {to}.")));

template <>
inline constexpr auto kTable<Film> = table(
    "The film of the scene, which aerostat film makes.",
    field(
        "duration_s", &Film::duration_s,
        number(0, kLongestFilm_s, "Length of the film in seconds, above {from} to {to}.").above()),
    field("fps", &Film::fps, number(0, 240, "Frames per second, above {from} to {to}.").above()),
    field("keys", &Film::keys, list(kMostKeyTracks, "Values that move, at most {to} of them.")),
    field("wind", &Film::wind,
          list(kMostWindLayers,
               "Profile of the wind: layers with rising heights, at most {to}. It carries balloons "
               "and clouds along. By default, it blows from the west at 3 m/s. Without any layer, "
               "balloons and clouds stand still.")),
    field("cloud_change_m_s", &Film::cloud_change_m_s,
          number(0, 1000,
                 "How fast clouds change their shape: the speed in metres per second at which "
                 "bulges rise through heaped clouds, {from} to {to}. The pattern that bends the "
                 "streaks of thin, high cloud moves ten times as fast. Films that show hours in "
                 "seconds want 50 or more. 0 keeps the shapes.")),
    field("turn_deg_s", &Film::turn_deg_s,
          number(-360, 360,
                 "Slow turn of balloons in the wind in degrees per second, {from} to {to}.")),
    field("launch_s", &Film::launch_s,
          number(0, kLongestFilm_s,
                 "Seconds from the beginning of the film within which the balloons of the festival "
                 "take off, {from} to {to}. Each has its own time, which follows from the "
                 "festival's seed, and stands on the ground until then; so their places are apart "
                 "on the ground. If it is 0, all fly from the beginning.")),
    field("climb_m_s", &Film::climb_m_s,
          number(0, 50,
                 "Speed in metres per second at which the balloons of the festival climb after "
                 "take-off, above {from} to {to}. They slow down towards their height.")
              .above()),
    field(
        "track_speed", &Film::track_speed,
        number(0, 100000,
               "How many seconds of the recorded flight of /balloon/track pass in a second of the "
               "film, {from} to {to}. The film begins at the moment of the flight that the track "
               "names by at or share, or else at its take-off.")),
    field("meter_s", &Film::meter_s,
          number(0, kLongestFilm_s,
                 "Seconds between the moments at which the light is metered, above {from} to {to}. "
                 "The exposure goes evenly from one to the next, so that it never flickers. It "
                 "does not matter if /image/exposure_ev is given.")
              .above()),
    field("shutter_angle_deg", &Film::shutter_angle_deg,
          number(0, 360,
                 "How long the shutter is open in each frame, in degrees of the frame's time, "
                 "{from} to {to}: what moves is blurred along its way. 180, half of the time, is "
                 "what cinema cameras have. 0 (the default) shows one moment, which is the "
                 "fastest. The shutter opens at the time of the frame.")),
    field("shutter_moments", &Film::shutter_moments,
          number(2, 64,
                 "How many moments a frame with an open shutter averages, {from} to {to}. They "
                 "share the samples of a pixel, of which there are at least as many. What moves "
                 "by more pixels within the shutter shows steps.")),
    field("camera", &Film::camera));

}  // namespace aerostat::scene::detail
