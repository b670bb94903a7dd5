#pragma once

#include <string>
#include <vector>

#include "geo/place.hpp"
#include "land/land.hpp"
#include "scene/geo_point.hpp"
#include "track/flight.hpp"

namespace aerostat::staging {

/// The height over the ground below which no balloon is put on its track.
inline constexpr double kClearance_m = 2.0;

/// A flight over land, and sentences for the user on what was mended.
struct FlightOverLand {
  track::Flight flight;
  std::vector<std::string> notes;
};

/// Returns the heights of land over the sea where its files have them, within 150 km of a place.
/// The land must have a place on the Earth and live as long as what is returned.
track::Ground ground_around(const land::Land& land, const geo::Place& middle);

/// Reads the track of a scene and fits its heights to the land. Throws Error{bad_data} or
/// Error{usage} of the track's reader, and Error{bad_data} if it is unknown where the land lies.
FlightOverLand flight_of(const scene::FlightTrack& track, const land::Land& land);

}  // namespace aerostat::staging
