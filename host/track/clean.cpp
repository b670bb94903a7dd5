#include "track/clean.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "track/distance.hpp"
#include "track/mend.hpp"
#include "track/standing.hpp"
#include "track/text.hpp"

namespace aerostat::track {

namespace {

/// At most so many fixes in a row are taken for outliers, and only where at least so many good ones
/// stand beside them.
constexpr std::size_t kMostInRow = 10;
constexpr std::size_t kFewestGood = 30;
constexpr double kKeptStanding_s = 60.0;

template <class Condition>
std::size_t drop(Track& track, Condition condition) {
  std::size_t dropped = 0;
  for (Segment& segment : track.segments) {
    const auto end = std::remove_if(segment.begin(), segment.end(), condition);
    dropped += static_cast<std::size_t>(segment.end() - end);
    segment.erase(end, segment.end());
  }
  const auto is_empty = [](const Segment& segment) { return segment.empty(); };
  track.segments.erase(std::remove_if(track.segments.begin(), track.segments.end(), is_empty),
                       track.segments.end());
  return dropped;
}

/// Finds the elements of a sequence that lie off it. `is_near(i, j)` says whether j can follow on
/// i. The sequence is cut where it jumps. A short piece is off if the way goes on behind it as
/// though it were not there, or if it stands alone at an end.
std::vector<bool> off_the_way(std::size_t count,
                              const std::function<bool(std::size_t, std::size_t)>& is_near) {
  std::vector<std::size_t> begins;  // of the pieces
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 0 || !is_near(i - 1, i)) begins.push_back(i);
  }
  std::vector<bool> is_off(count, false);
  if (begins.size() < 2) return is_off;
  begins.push_back(count);
  const auto length = [&](std::size_t piece) { return begins[piece + 1] - begins[piece]; };
  const auto mark = [&](std::size_t first, std::size_t end) {
    std::fill(is_off.begin() + static_cast<std::ptrdiff_t>(first),
              is_off.begin() + static_cast<std::ptrdiff_t>(end), true);
  };
  const std::size_t pieces = begins.size() - 1;
  std::size_t first = 0;
  if (length(0) <= kMostInRow && length(1) >= kFewestGood) mark(0, begins[first = 1]);
  for (std::size_t piece = first; piece + 1 < pieces;) {
    std::size_t next = piece + 1;
    while (next < pieces && begins[next] - begins[piece + 1] <= kMostInRow &&
           !is_near(begins[piece + 1] - 1, begins[next])) {
      ++next;
    }
    const bool is_detour =
        next < pieces && next > piece + 1 && begins[next] - begins[piece + 1] <= kMostInRow;
    if (is_detour) mark(begins[piece + 1], begins[next]);
    const bool is_tail =
        next == pieces && count - begins[piece + 1] <= kMostInRow && length(piece) >= kFewestGood;
    if (is_tail) mark(begins[piece + 1], count);
    piece = is_detour || is_tail ? next : piece + 1;
  }
  return is_off;
}

std::size_t drop_outliers(Track& track, double fastest_mps) {
  const std::vector<Fix> fixes = all_fixes(track);
  const std::vector<bool> is_off = off_the_way(fixes.size(), [&](std::size_t i, std::size_t j) {
    const double seconds = std::max(*fixes[j].time_s - *fixes[i].time_s, 1.0);
    return distance_m(fixes[i].place, fixes[j].place) <= fastest_mps * seconds;
  });
  std::size_t index = 0;
  return drop(track, [&](const Fix&) { return is_off[index++]; });
}

std::size_t drop_wrong_heights(Track& track, std::optional<double> Fix::*height,
                               double fastest_mps) {
  std::vector<Fix*> fixes;
  for (Segment& segment : track.segments) {
    for (Fix& fix : segment) {
      if (fix.*height) fixes.push_back(&fix);
    }
  }
  const std::vector<bool> is_off = off_the_way(fixes.size(), [&](std::size_t i, std::size_t j) {
    const double seconds = std::max(*fixes[j]->time_s - *fixes[i]->time_s, 1.0);
    return std::abs(*(fixes[j]->*height) - *(fixes[i]->*height)) <= fastest_mps * seconds;
  });
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    if (is_off[i]) (fixes[i]->*height).reset();
  }
  return static_cast<std::size_t>(std::count(is_off.begin(), is_off.end(), true));
}

void cut_standing(Track& track) {
  const std::vector<Fix> fixes = all_fixes(track);
  const Standing standing = standing_ends(fixes);
  const double leaves_s = *fixes[standing.start].time_s;
  const double arrives_s = *fixes[fixes.size() - 1 - standing.end].time_s;
  const double first_s = leaves_s - kKeptStanding_s, last_s = arrives_s + kKeptStanding_s;
  drop(track, [&](const Fix& fix) { return *fix.time_s < first_s || *fix.time_s > last_s; });
  track.cut_start_s = *track.segments.front().front().time_s - *fixes.front().time_s;
  track.cut_end_s = *fixes.back().time_s - *track.segments.back().back().time_s;
}

std::size_t drop_repeated_places(Track& track) {
  std::optional<geo::Place> last;
  return drop(track, [&](const Fix& fix) {
    const bool is_same = last == fix.place;
    last = fix.place;
    return is_same;
  });
}

void add_notes(const CleanReport& report, Track& track) {
  const auto note = [&](std::size_t count, const char* what) {
    if (count == 0) return;
    track.notes.push_back(
        fmt::format("Cleaning left out {} {}.", counted(count, "fix", "fixes"), what));
  };
  note(report.invalid, "that the file marks as doubtful or that no place on the Earth has");
  note(report.nowhere, "at 0 N 0 E, which receivers write when they know no place");
  note(report.duplicates, "at the place of the one before");
  note(report.outliers, "far off the way");
  if (report.wrong_heights > 0) {
    track.notes.push_back(fmt::format("Cleaning left out {} far off the others.",
                                      counted(report.wrong_heights, "height", "heights")));
  }
  const auto cut = [&](double seconds, const char* where) {
    if (seconds < 1.0) return;
    track.notes.push_back(
        fmt::format("{} of standing {} were cut.", duration_text(seconds), where));
  };
  cut(report.cut_start_s, "before the start");
  cut(report.cut_end_s, "after the end");
}

}  // namespace

std::vector<Fix> all_fixes(const Track& track) {
  std::vector<Fix> fixes;
  fixes.reserve(track.fix_count());
  for (const Segment& segment : track.segments) {
    fixes.insert(fixes.end(), segment.begin(), segment.end());
  }
  return fixes;
}

Cleaned clean(Track track, const CleanOptions& options) {
  CleanReport report;
  report.invalid = drop(track, [](const Fix& fix) { return !fix.valid; });
  report.nowhere = drop(track, [](const Fix& fix) { return !is_usable(fix); });
  if (track.fix_count() == 0) {
    throw Error(ErrorKind::bad_data, "no fix of the track can be used");
  }
  if (track.clock == Clock::none) {
    report.duplicates = drop_repeated_places(track);
  } else {
    report.outliers = drop_outliers(track, options.fastest_mps);
    report.wrong_heights = drop_wrong_heights(track, &Fix::gnss_m, options.fastest_climb_mps) +
                           drop_wrong_heights(track, &Fix::pressure_m, options.fastest_climb_mps);
    if (options.cut_standing) cut_standing(track);
  }
  report.cut_start_s = track.cut_start_s;
  report.cut_end_s = track.cut_end_s;
  add_notes(report, track);
  return {std::move(track), report};
}

}  // namespace aerostat::track
