#include "staging/flight_point.hpp"

#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "geo/transform.hpp"
#include "track/clean.hpp"
#include "track/flight.hpp"
#include "track/read.hpp"
#include "track/text.hpp"

namespace aerostat::staging {
namespace {

constexpr double kUsualShare = 0.5;
constexpr double kReach_m =
    150000.0;  // of the land around the first fix that heights are fitted to
constexpr double kClearance_m = 2.0;

double seconds_of(const std::string& text, const char* key) {
  const auto time = track::time_of(text);
  if (time) return time->time_s;
  throw Error(ErrorKind::bad_data,
              fmt::format("/balloon/track/{}: found \"{}\", expected a time such as "
                          "2023-10-02T07:45:10Z",
                          key, text));
}

track::ReadOptions read_options(const scene::FlightTrack& track) {
  track::ReadOptions options;
  if (track.number > 0) options.index = static_cast<std::size_t>(track.number - 1);
  if (!track.start.empty()) options.start_s = seconds_of(track.start, "start");
  options.interval_s = track.interval_s;
  return options;
}

/// Returns the heights of the land over the sea, where a file has them.
track::Ground ground_of(const land::Land& land, const geo::Place& middle) {
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

}  // namespace

FlightPoint flight_point(const scene::FlightTrack& track, const land::Land& land) {
  if (!land.has_place()) {
    throw Error(ErrorKind::bad_data,
                "/balloon/track: a track needs to know where the land lies; name the coordinate "
                "reference system of the source by /terrain/crs");
  }
  const track::Cleaned cleaned = track::clean(track::read_file(track.file, read_options(track)));
  const geo::Place first = cleaned.track.segments.front().front().place;
  track::FitOptions options;
  options.clearance_m = kClearance_m;
  const track::Flight flight = track::fit_heights(cleaned.track, ground_of(land, first), options);
  const track::Position at = track.at.empty() ? flight.at_share(track.share.value_or(kUsualShare))
                                              : flight.at(seconds_of(track.at, "at"));
  FlightPoint point{at.place, at.height_m, at.time_s, {}};
  const std::string name = std::filesystem::path(track.file).filename().string();
  for (const auto* notes : {&cleaned.track.notes, &flight.fit().notes}) {
    for (const std::string& note : *notes) point.notes.push_back(name + ": " + note);
  }
  if (!at.ground_m) {
    point.notes.push_back(name + ": the flight is over ground of which the source has no heights.");
  } else if (at.is_clamped) {
    point.notes.push_back(fmt::format("{}: the balloon was lifted to {} m above the ground there.",
                                      name, kClearance_m));
  }
  return point;
}

std::pair<std::string, std::string> date_and_time(double time_s) {
  const std::string text = track::utc_text(std::floor(time_s));  // "2023-10-02 07:45:10 UTC"
  return {text.substr(0, 10), text.substr(11, 8) + "Z"};
}

}  // namespace aerostat::staging
