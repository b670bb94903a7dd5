#pragma once

#include "track/track.hpp"

/// Functions that correct the fixes of a file.
namespace aerostat::track {

/// Returns whether the place of a fix can be used: the file calls it valid, and it is not 0 N 0 E,
/// which receivers write as long as they know no place.
bool is_usable(const Fix& fix);

/// Takes heights for unknown that nothing that flies reaches (100 km over and 12 km below the sea).
void drop_absurd_heights(Track& track);

/// Takes heights of exactly 0 for unknown if those around them are far from 0 or 0 as well. Loggers
/// write 0 as long as they know no height.
void drop_zero_heights(Track& track);

}  // namespace aerostat::track
