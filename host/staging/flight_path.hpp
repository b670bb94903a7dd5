#pragma once

#include <optional>

#include "core/math.hpp"
#include "geo/place.hpp"
#include "scene/geo_point.hpp"
#include "scene/land.hpp"
#include "terrain/relief_cache.hpp"
#include "track/flight.hpp"

namespace aerostat::staging {

/// A recorded flight in the coordinates of a scene, by seconds from a beginning.
class FlightPath {
 public:
  struct Point {
    dvec3 position{0.0};           // y counts from the sea
    std::optional<double> time_s;  // UTC, seconds since 1970
  };

  /// Takes the track of a balloon and the terrain of a scene that stage() has filled in. The flight
  /// begins at the point that the track names, or at its take-off if it names none. Throws the
  /// errors of flight_point, and Error{bad_data} for a track without times.
  FlightPath(const scene::FlightTrack& track, const scene::Terrain& terrain,
             terrain::ReliefCache& reliefs);

  /// Returns the point some seconds after the beginning, at most at the landing.
  Point after(double seconds) const;

 private:
  track::Flight flight_;
  geo::Place middle_;
  bool is_curved_;
  double start_share_ = 0.0, duration_s_ = 1.0;
};

}  // namespace aerostat::staging
