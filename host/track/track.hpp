#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geo/place.hpp"

/// Tracks: where something flew or went, as loggers and programs for maps write it.
namespace aerostat::track {

/// One recorded place.
struct Fix {
  geo::Place place;
  std::optional<double> gnss_m;      // what the file gives as height (GNSS, ele, altitude)
  std::optional<double> pressure_m;  // height in the standard atmosphere over 1013.25 hPa
  std::optional<double> time_s;      // seconds since 1970-01-01 00:00 UTC, see Clock
  bool valid = true;                 // false: the file itself calls the place doubtful
};

using Segment = std::vector<Fix>;

enum class Format { gpx, igc, kml };

/// What the heights `gnss_m` are measured from, as far as the file says so.
enum class HeightReference { unknown, sea, ellipsoid, ground };

/// What the times of the fixes are good for.
enum class Clock {
  none,    // no fix has a time
  of_day,  // the times are seconds since midnight UTC of a day that the file does not name
  utc,     // the times are seconds since 1970-01-01 00:00 UTC
};

/// One track. If it has times, every fix has one, and the times rise from fix to fix, over the
/// segments as well. Between two segments the logger recorded nothing.
struct Track {
  Format format = Format::gpx;
  std::string name;  // UTF-8; empty if the file gives none
  std::vector<Segment> segments;
  Clock clock = Clock::none;
  HeightReference reference = HeightReference::unknown;
  std::vector<std::string> notes;  // sentences on what was guessed, left out or mended
  double cut_start_s = 0.0;        // how long the logger stood before the first fix, see clean
  double cut_end_s = 0.0;          // and after the last one

  std::size_t fix_count() const;
};

/// The largest file of a track that is read, in bytes.
inline constexpr std::size_t kMostTrackBytes = std::size_t{256} << 20;
/// The most fixes that are read from a file.
inline constexpr std::size_t kMostFixes = 5'000'000;

/// Returns "GPX", "IGC" or "KML".
const char* name_of(Format format);

}  // namespace aerostat::track
