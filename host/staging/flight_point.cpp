#include "staging/flight_point.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "staging/flight_of.hpp"
#include "staging/track_time.hpp"
#include "track/flight.hpp"
#include "track/text.hpp"

namespace aerostat::staging {
namespace {

constexpr double kUsualShare = 0.5;

}  // namespace

double track_time(const std::string& text, const char* key) {
  const auto time = track::time_of(text);
  if (time) return time->time_s;
  throw Error(ErrorKind::bad_data,
              fmt::format("/balloon/track/{}: found \"{}\", expected a time such as "
                          "2023-10-02T07:45:10Z",
                          key, text));
}

FlightPoint flight_point(const scene::FlightTrack& track, const land::Land& land) {
  FlightOverLand found = flight_of(track, land);
  const track::Flight& flight = found.flight;
  const track::Position at = track.at.empty() ? flight.at_share(track.share.value_or(kUsualShare))
                                              : flight.at(track_time(track.at, "at"));
  FlightPoint point{at.place, at.height_m, at.time_s, std::move(found.notes)};
  const std::string name = std::filesystem::path(track.file).filename().string();
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
