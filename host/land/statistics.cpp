#include "land/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace aerostat::land {
namespace {

// What tells that 0 m is the level of a sea. Dry land is nowhere lower than the shore of the Dead
// Sea, so that what lies deeper is a sea floor.
constexpr double kSeaShare = 0.01;
constexpr float kLowestDryLand_m = -450.0f;

/// Takes a height that occurs `count` times into the two lowest ones (sign 1) or highest ones
/// (sign -1).
void take(float height, std::uint64_t count, float sign, float& end, float& next,
          std::uint64_t& at_end) {
  if (height == end) {
    at_end += count;
  } else if (sign * height < sign * end) {
    next = end;
    end = height;
    at_end = count;
  } else if (next == end || sign * height < sign * next) {
    next = height;
  }
}

}  // namespace

void RasterStatistics::add(const std::vector<float>& heights) {
  for (const float height : heights) {
    ++samples;
    // Most heights lie between the ends and above the sea.
    if (height > next_lowest && height < next_highest && height > 0.0f && lowest < next_lowest &&
        next_highest < highest) {
      continue;
    }
    if (std::isnan(height)) {
      ++voids;
      continue;
    }
    if (height <= 0.0f) height == 0.0f ? ++at_zero : ++below_zero;
    if (known() == 1) {
      lowest = next_lowest = highest = next_highest = height;
      at_lowest = at_highest = 1;
      continue;
    }
    if (height <= next_lowest || next_lowest == lowest) {
      take(height, 1, 1.0f, lowest, next_lowest, at_lowest);
    }
    if (height >= next_highest || next_highest == highest) {
      take(height, 1, -1.0f, highest, next_highest, at_highest);
    }
  }
}

void RasterStatistics::add(const RasterStatistics& other) {
  const std::uint64_t before = known();
  samples += other.samples;
  voids += other.voids;
  at_zero += other.at_zero;
  below_zero += other.below_zero;
  if (other.known() == 0) return;
  if (before == 0) {
    lowest = other.lowest, next_lowest = other.next_lowest, at_lowest = other.at_lowest;
    highest = other.highest, next_highest = other.next_highest, at_highest = other.at_highest;
    return;
  }
  take(other.lowest, other.at_lowest, 1.0f, lowest, next_lowest, at_lowest);
  if (other.next_lowest != other.lowest) {
    take(other.next_lowest, 0, 1.0f, lowest, next_lowest, at_lowest);
  }
  take(other.highest, other.at_highest, -1.0f, highest, next_highest, at_highest);
  if (other.next_highest != other.highest) {
    take(other.next_highest, 0, -1.0f, highest, next_highest, at_highest);
  }
}

bool show_sea(const RasterStatistics& statistics) {
  if (statistics.known() == 0) return false;
  const double zero =
      static_cast<double>(statistics.at_zero) / static_cast<double>(statistics.known());
  return (zero >= kSeaShare && statistics.highest > 0.0f) || statistics.lowest < kLowestDryLand_m;
}

}  // namespace aerostat::land
