#pragma once

#include <cstddef>
#include <vector>

#include "track/track.hpp"

namespace aerostat::track {

/// The fixes at both ends of a track at which the logger stood still.
struct Standing {
  std::size_t start = 0;        // this many fixes at the beginning
  std::size_t end = 0;          // and this many at the end
  bool rests_at_start = false;  // they are enough to say that the logger lay on the ground
  bool rests_at_end = false;
};

/// Finds how long a logger stood before it left and after it arrived. It has left when it stays
/// farther than 30 m away, or higher or lower than 15 m, for half a minute. `fixes` have times. If
/// they never leave, both numbers are 0.
Standing standing_ends(const std::vector<Fix>& fixes);

/// Returns the height of a fix by GNSS, or else by pressure.
inline std::optional<double> any_height(const Fix& fix) {
  return fix.gnss_m ? fix.gnss_m : fix.pressure_m;
}

/// Returns the median of values, or 0 if there are none.
double median(std::vector<double> values);

}  // namespace aerostat::track
