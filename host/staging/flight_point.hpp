#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geo/place.hpp"
#include "land/land.hpp"
#include "scene/geo_point.hpp"

namespace aerostat::staging {

/// Where a balloon was on its track.
struct FlightPoint {
  geo::Place place;
  double height_m = 0.0;           // over the sea
  std::optional<double> time_s;    // UTC, seconds since 1970
  std::vector<std::string> notes;  // sentences for the user
};

/// Returns the point of a track that a scene asks for. Heights of the track are fitted to the land.
/// Throws Error{bad_data} or Error{usage} of the track's reader, and Error{bad_data} for a time
/// that is none.
FlightPoint flight_point(const scene::FlightTrack& track, const land::Land& land);

/// Returns the date of a time in seconds since 1970, as "2023-10-02", and its time, as "07:45:10Z".
std::pair<std::string, std::string> date_and_time(double time_s);

}  // namespace aerostat::staging
