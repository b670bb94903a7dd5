#pragma once

#include "scene/field.hpp"
#include "scene/geo_point.hpp"

/// Places on the Earth.
namespace aerostat::scene::detail {

template <>
inline constexpr auto kTable<GeoPoint> = table(
    "Place on the Earth. Only scenes on real land have such places.",
    field("latitude_deg", &GeoPoint::latitude_deg,
          number(-90, 90, "Latitude in degrees, {from} to {to} (north).").required()),
    field("longitude_deg", &GeoPoint::longitude_deg,
          number(-360, 360, "Longitude in degrees, {from} to {to}; east is positive.").required()),
    field("height_m", &GeoPoint::height_m,
          number(-100000, 100000,
                 "Height in metres, {from} to {to}, above the level that height_above names.")));

template <>
inline constexpr auto kTable<TrackLine> = table(
    "Line along the way of a flight. An empty object is enough.",
    field("width_m", &TrackLine::width_m,
          number(0.01, 1000, "Thickness of the line in metres, {from} to {to}.")),
    field("color", &TrackLine::color, color("Albedo of the line in the air.")),
    field("on_ground", &TrackLine::on_ground,
          truth("Whether there is another line on the ground below.")),
    field("ground_color", &TrackLine::ground_color, color("Albedo of the line on the ground.")));

template <>
inline constexpr auto kTable<FlightTrack> = table(
    "Flight that a logger recorded. The balloon is where it was at a moment, and the sun as well, "
    "unless the scene gives another. It wins over position.",
    field("file", &FlightTrack::file,
          text("Name of an IGC, GPX, KML or KMZ file, relative to the folder of the scene file.")
              .required()),
    field("at", &FlightTrack::at,
          text("Time of the flight, such as 2023-10-02T07:45:10Z. It wins over share.")),
    field(
        "share", &FlightTrack::share,
        number(
            0, 1,
            "Share of the flight's time, {from} (take-off) to {to} (landing). If neither it nor a "
            "time is given, it is 0.5.")),
    field("number", &FlightTrack::number,
          number(0, 100000, "Number of the track in the file, {from} (the longest) to {to}.")),
    field("start", &FlightTrack::start, text("Time of the first fix, for tracks without times.")),
    field("interval_s", &FlightTrack::interval_s,
          number(0, 86400, "Seconds from fix to fix, {from} to {to}, for tracks without times.")),
    field("line", &FlightTrack::line));

}  // namespace aerostat::scene::detail
