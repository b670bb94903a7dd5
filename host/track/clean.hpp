#pragma once

#include <cstddef>

#include "track/track.hpp"

namespace aerostat::track {

struct CleanOptions {
  /// Fixes are outliers only if the way to them and back is faster than this. Gliders and balloons
  /// stay far below it.
  double fastest_mps = 150.0;
  double fastest_climb_mps = 80.0;  // the same for heights
  /// Whether standing before the way and after it is cut, but for a minute.
  bool cut_standing = true;
};

/// What clean left out.
struct CleanReport {
  std::size_t invalid = 0;        // the file calls them doubtful, or they are no places
  std::size_t nowhere = 0;        // at 0 N 0 E
  std::size_t duplicates = 0;     // the same place twice in a track without times
  std::size_t outliers = 0;       // single fixes far off the way
  std::size_t wrong_heights = 0;  // heights far off the others, at fixes that were kept
  double cut_start_s = 0.0;       // standing at the start
  double cut_end_s = 0.0;         // and at the end
};

struct Cleaned {
  Track track;
  CleanReport report;
};

/// Leaves out what cannot be true and nothing else, and adds to the notes how much that was. Where
/// nothing was recorded, nothing is filled in. Throws Error{bad_data} if no fix is left.
Cleaned clean(Track track, const CleanOptions& options = {});

/// Returns the fixes of all segments in one sequence.
std::vector<Fix> all_fixes(const Track& track);

}  // namespace aerostat::track
