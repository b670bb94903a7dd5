#include "track/mend.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "track/text.hpp"

namespace aerostat::track {

namespace {

/// Heights this far from 0 do not follow on a true height of 0.
constexpr double kFarFromZero_m = 50.0;

/// Returns whether heights of 0 between two other heights cannot be true.
bool is_unknown(std::optional<double> last, std::optional<double> next) {
  if (!last && !next) return true;
  const auto is_far = [](double height_m) { return std::abs(height_m) >= kFarFromZero_m; };
  return is_far(last.value_or(kFarFromZero_m)) && is_far(next.value_or(kFarFromZero_m));
}

std::size_t drop_zeros(Track& track, std::optional<double> Fix::*height) {
  std::vector<Fix*> zeros;  // those since the last other height
  std::optional<double> last;
  std::size_t dropped = 0;
  const auto settle = [&](std::optional<double> next) {
    if (is_unknown(last, next)) {
      for (Fix* fix : zeros) (fix->*height).reset();
      dropped += zeros.size();
    }
    zeros.clear();
  };
  for (Segment& segment : track.segments) {
    for (Fix& fix : segment) {
      if (!fix.valid || !(fix.*height)) continue;
      if (*(fix.*height) == 0.0) {
        zeros.push_back(&fix);
        continue;
      }
      settle(fix.*height);
      last = fix.*height;
    }
  }
  settle(std::nullopt);
  return dropped;
}

}  // namespace

bool is_usable(const Fix& fix) {
  return fix.valid && (fix.place.latitude_deg != 0.0 || fix.place.longitude_deg != 0.0);
}

void drop_absurd_heights(Track& track) {
  constexpr double kLowest_m = -12e3, kHighest_m = 100e3;
  std::size_t dropped = 0;
  for (Segment& segment : track.segments) {
    for (Fix& fix : segment) {
      for (std::optional<double>* height : {&fix.gnss_m, &fix.pressure_m}) {
        if (!*height || (**height >= kLowest_m && **height <= kHighest_m)) continue;
        height->reset();
        ++dropped;
      }
    }
  }
  if (dropped == 0) return;
  track.notes.push_back(fmt::format("{} beyond all bounds and taken for unknown.",
                                    counted(dropped, "height was", "heights were")));
}

void drop_zero_heights(Track& track) {
  const std::size_t dropped = drop_zeros(track, &Fix::gnss_m) + drop_zeros(track, &Fix::pressure_m);
  if (dropped == 0) return;
  track.notes.push_back(fmt::format("{} taken for unknown, because no other height is near 0.",
                                    counted(dropped, "height of 0 was", "heights of 0 were")));
}

}  // namespace aerostat::track
