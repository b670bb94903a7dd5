#include "take_track.hpp"

#include <cmath>
#include <exception>
#include <optional>

#include "core/error.hpp"
#include "track/clean.hpp"
#include "track/flight.hpp"
#include "track/read.hpp"
#include "track/summary.hpp"
#include "track/text.hpp"

namespace aerostat::test {

namespace {

using track::Flight;
using track::Track;

std::string fault_of_times(const Track& track) {
  std::optional<double> last_s;
  for (const track::Segment& segment : track.segments) {
    if (segment.empty()) return "an empty segment";
    for (const track::Fix& fix : segment) {
      if (fix.time_s.has_value() != (track.clock != track::Clock::none)) return "a missing time";
      if (last_s && fix.time_s && *fix.time_s <= *last_s) return "times that do not rise";
      last_s = fix.time_s;
    }
  }
  return "";
}

bool is_sound(const track::Position& position) {
  return std::abs(position.place.latitude_deg) <= 90.0 &&
         std::abs(position.place.longitude_deg) <= 180.0 && std::isfinite(position.height_m) &&
         (!position.ground_m || position.height_m >= *position.ground_m + 1.0 - 1e-6);
}

std::string fault_of_flight(const Flight& flight) {
  for (const double share : {0.0, 1e-9, 0.1, 0.5, 0.77, 1.0}) {
    if (!is_sound(flight.at_share(share))) return "a position that is not sound";
  }
  const track::Summary summary = track::summary_of(flight);
  if (!std::isfinite(summary.way_m) || !std::isfinite(summary.duration_s)) return "endless figures";
  if (flight.takeoff() > flight.landing()) return "a landing before the take-off";
  if (flight.clock() != track::Clock::utc) return "";
  return is_sound(flight.at(flight.end())) ? "" : "an end that is not sound";
}

std::string fault_of_notes(const Track& track) {
  for (const std::string& note : track.notes) {
    if (note.empty() || note.back() != '.' || !track::is_utf8(note)) return "note: " + note;
  }
  return track::is_utf8(track.name) ? "" : "a name that is not UTF-8";
}

}  // namespace

std::string fault_of_track(std::string_view bytes, bool& is_read) {
  is_read = false;
  try {
    const Track track = track::read_bytes(bytes, "fuzz");
    is_read = true;
    if (const std::string fault = fault_of_times(track); !fault.empty()) return fault;
    const track::Cleaned cleaned = track::clean(track);
    if (const std::string fault = fault_of_times(cleaned.track); !fault.empty()) return fault;
    const track::Ground waves = [](const geo::Place& place) -> std::optional<double> {
      if (place.latitude_deg > 60.0) return std::nullopt;
      return 800.0 + 600.0 * std::sin(500.0 * place.longitude_deg);
    };
    for (const track::Ground& ground : {track::Ground(), waves}) {
      const std::string fault = fault_of_flight(track::fit_heights(cleaned.track, ground));
      if (!fault.empty()) return fault;
    }
    return fault_of_notes(cleaned.track);
  } catch (const Error& error) {
    const bool is_expected = error.kind() == ErrorKind::bad_data;
    return is_expected ? "" : std::string("an unexpected error: ") + error.what();
  } catch (const std::exception& error) {
    return std::string("not an error of aerostat's own: ") + error.what();
  }
}

}  // namespace aerostat::test
