#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "track/track.hpp"

/// The tracks of a file as the reader of its format returns them, before one is chosen and its
/// fixes are mended.
namespace aerostat::track {

/// The most tracks that are read from a file.
inline constexpr std::size_t kMostTracks = 100'000;

/// A track as the file has it.
struct RawTrack {
  std::string name;
  std::vector<Segment> segments;
  HeightReference reference = HeightReference::unknown;
  Clock clock = Clock::utc;        // of the fixes that have a time
  std::vector<std::string> notes;  // on this track only
};

/// All tracks of a file.
struct RawFile {
  std::vector<RawTrack> tracks;
  std::vector<std::string> notes;  // on the whole file
};

/// These functions read files of one format. They throw Error{bad_data} whose message does not name
/// the file yet.
RawFile read_gpx(std::string_view bytes);
RawFile read_igc(std::string_view bytes);
RawFile read_kml(std::string_view bytes);

/// Returns whether a line is a fix of an IGC file.
bool is_igc_fix(std::string_view line);

/// Returns the text behind the byte order mark of UTF-8, if there is one.
std::string_view without_mark(std::string_view bytes);

/// Throws Error{bad_data} if a file has more tracks than kMostTracks.
void require_few(std::size_t tracks);

/// Adds a fix to the last segment. A place that the Earth does not have becomes invalid. Throws
/// Error{bad_data} if the file has more than kMostFixes, which `count` counts.
void add_fix(RawTrack& track, const Fix& fix, std::size_t& count);

}  // namespace aerostat::track
