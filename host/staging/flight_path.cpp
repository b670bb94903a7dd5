#include "staging/flight_path.hpp"

#include <algorithm>
#include <memory>

#include "core/error.hpp"
#include "geo/transform.hpp"
#include "land/land.hpp"
#include "staging/flight_of.hpp"
#include "staging/track_time.hpp"
#include "terrain/real_land.hpp"

namespace aerostat::staging {
namespace {

track::Flight read_flight(const scene::FlightTrack& track, const scene::Terrain& terrain,
                          terrain::ReliefCache& reliefs) {
  // stage() has told the notes before.
  return flight_of(track, *terrain::real_land(terrain, reliefs.lands)).flight;
}

geo::Place middle_of(const scene::Terrain& terrain, terrain::ReliefCache& reliefs) {
  const auto middle =
      terrain::middle_point(terrain, *terrain::real_land(terrain, reliefs.lands)).place;
  if (middle) return *middle;
  throw Error(ErrorKind::bad_data, "/balloon/track: the place of the land is unknown");
}

}  // namespace

FlightPath::FlightPath(const scene::FlightTrack& track, const scene::Terrain& terrain,
                       terrain::ReliefCache& reliefs)
    : flight_(read_flight(track, terrain, reliefs)),
      middle_(middle_of(terrain, reliefs)),
      is_curved_(terrain.curved) {
  if (flight_.clock() == track::Clock::none) {
    throw Error(ErrorKind::bad_data,
                "/balloon/track: the track has no times, which a film needs; give "
                "/balloon/track/interval_s");
  }
  const auto& times = flight_.course().times;
  duration_s_ = std::max(times[flight_.landing()] - times[flight_.takeoff()], 1e-3);
  const bool is_given = !track.at.empty() || track.share.has_value();
  if (!is_given) return;
  start_share_ = track.share.value_or(0.0);
  if (track.at.empty()) return;
  const auto takeoff = flight_.at_share(0.0).time_s;
  // A track without a date has no time by which it could begin, which at() says.
  const double start = track_time(track.at, "at");
  flight_.at(start);
  if (takeoff) start_share_ = (start - *takeoff) / duration_s_;
}

FlightPath::Point FlightPath::after(double seconds) const {
  const double share = std::clamp(start_share_ + seconds / duration_s_, 0.0, 1.0);
  const track::Position at = flight_.at_share(share);
  const dvec2 local = geo::local_point(middle_, at.place);
  const double drop = is_curved_ ? geo::curvature_drop(glm::length(local)) : 0.0;
  return {{local.x, at.height_m - drop, local.y}, at.time_s};
}

}  // namespace aerostat::staging
