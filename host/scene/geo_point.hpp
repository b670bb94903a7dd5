#pragma once

#include <optional>
#include <string>

#include "core/math.hpp"

/// Places on the Earth in a scene on real land. Staging turns them into positions.
namespace aerostat::scene {

/// A latitude and longitude on WGS 84, and a height from the level of the position that it stands
/// for.
struct GeoPoint {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double height_m = 0.0;

  bool operator==(const GeoPoint&) const = default;
};

/// A line through the air along a flight, and one on the ground below it.
struct TrackLine {
  double width_m = 1.5;
  vec3 color{0.9f, 0.16f, 0.03f};
  bool on_ground = true;  // whether there is a line on the ground
  vec3 ground_color{0.02f, 0.02f, 0.02f};

  bool operator==(const TrackLine&) const = default;
};

/// A point of a flight that a logger recorded.
struct FlightTrack {
  std::string file;
  std::string at;                    // time such as 2023-10-02T07:45:10Z; empty: by share
  std::optional<double> share;       // of the time: 0 at take-off, 1 at landing
  int number = 0;                    // of the track in the file, from 1; 0: the longest
  std::string start;                 // time of the first fix, for tracks without times
  std::optional<double> interval_s;  // between their fixes
  std::optional<TrackLine> line;     // shows the way

  bool operator==(const FlightTrack&) const = default;
};

}  // namespace aerostat::scene
