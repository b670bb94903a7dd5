#include "staging/flight_of.hpp"

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/error.hpp"
#include "geo/transform.hpp"
#include "staging/track_time.hpp"
#include "track/clean.hpp"
#include "track/read.hpp"

namespace aerostat::staging {
namespace {

/// How far land around the first fix is looked at when heights are fitted.
constexpr double kReach_m = 150000.0;

track::ReadOptions read_options(const scene::FlightTrack& track) {
  track::ReadOptions options;
  if (track.number > 0) options.index = static_cast<std::size_t>(track.number - 1);
  if (!track.start.empty()) options.start_s = track_time(track.start, "start");
  options.interval_s = track.interval_s;
  return options;
}

}  // namespace

track::Ground ground_around(const land::Land& land, const geo::Place& middle) {
  const auto local = land.around({middle, {}}, kReach_m);
  const auto cell = static_cast<float>(land.cell_m());
  return [local, middle, cell](const geo::Place& place) -> std::optional<double> {
    const dvec2 point = geo::local_point(middle, place);
    if (!(glm::length(point) < kReach_m) || !local->is_known(point.x, point.y)) return std::nullopt;
    const auto east = static_cast<float>(point.x), south = static_cast<float>(point.y);
    float height = 0.0f, unused = 0.0f, unused_too = 0.0f;
    local->sample(
        {{&east, 1}, {&south, 1}, {&cell, 1}, {&height, 1}, {&unused, 1}, {&unused_too, 1}});
    return height;
  };
}

FlightOverLand flight_of(const scene::FlightTrack& track, const land::Land& land) {
  if (!land.has_place()) {
    throw Error(ErrorKind::bad_data,
                "/balloon/track: a track needs to know where the land lies; name the coordinate "
                "reference system of the source by /terrain/crs");
  }
  const track::Cleaned cleaned = track::clean(track::read_file(track.file, read_options(track)));
  const geo::Place first = cleaned.track.segments.front().front().place;
  track::FitOptions options;
  options.clearance_m = kClearance_m;
  FlightOverLand found{track::fit_heights(cleaned.track, ground_around(land, first), options), {}};
  const std::string name = std::filesystem::path(track.file).filename().string();
  for (const auto* notes : {&cleaned.track.notes, &found.flight.fit().notes}) {
    for (const std::string& note : *notes) found.notes.push_back(name + ": " + note);
  }
  return found;
}

}  // namespace aerostat::staging
