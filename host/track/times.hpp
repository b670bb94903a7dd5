#pragma once

#include "track/raw.hpp"
#include "track/read.hpp"
#include "track/track.hpp"

namespace aerostat::track {

/// Makes the times of a track keep the promise of Track: all fixes have a time, and the times rise,
/// or no fix has one. Fixes that stand in the way are left out, and the notes say so. A track
/// without times that can be used gets those of the options. Throws Error{usage} if the options are
/// no times.
void settle_times(Track& track, const ReadOptions& options);

/// Returns for each time whether it belongs to the longest part of the sequence that never falls.
std::vector<bool> rising_part(const std::vector<double>& times_s);

}  // namespace aerostat::track
