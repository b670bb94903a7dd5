#pragma once

#include <memory>

#include "land/cover.hpp"
#include "land/land.hpp"
#include "land/water_map.hpp"

namespace aerostat::terrain {

/// The lakes and rivers of land cover, with levels from the heights of the land. It never changes
/// and may be used from any thread.
class CoverWater {
 public:
  /// Looks for water in the square that reaches `reach_m` from the middle of the local frame.
  /// Water of a sea at 0 m is left aside if `has_sea` is true.
  CoverWater(const land::Cover& cover, const land::LocalLand& local, bool has_sea, double reach_m);

  /// Returns the water at a point of the local frame, its distance from the shore in metres.
  land::WaterPoint at(double east_m, double south_m, double spacing_m) const;

 private:
  double reach_m_, cell_m_;
  std::unique_ptr<const land::WaterMap> map_;
};

}  // namespace aerostat::terrain
