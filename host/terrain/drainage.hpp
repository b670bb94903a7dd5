#pragma once

#include <cstdint>
#include <functional>

#include "height_grid.hpp"

namespace aerostat::terrain {

/// The properties of the ground at a point, for the relief that rivers cut.
struct Bedrock {
  float uplift = 1.0f;    // relative rate, >= 0; more uplift makes steeper, higher ground
  float steepest = 0.8f;  // tangent at which slopes fail
  float outlet_m = 0.0f;  // height of an outlet
  bool outlet = false;    // rivers end here
};

struct DrainageOptions {
  int coarse_nodes = 33;                         // nodes along a side, at the first level
  std::vector<int> rounds = {20, 14, 10, 6, 3};  // rounds per level; a level doubles resolution
  int levels_left_out = 0;                       // number of last levels to leave out
  double size_m = 40000.0;
  double height_m = 2400.0;     // one point in a thousand is higher
  float concavity = 0.5f;       // slope ~ area^-concavity
  float floor_m = 60.0f;        // half width of the flat floor of a valley that drains 1 km^2
  float floor_growth = 0.4f;    // the width grows with area^floor_growth
  float floor_area_km2 = 1.5f;  // smaller valleys have no floor
  std::uint32_t seed = 1;
};

/// The number of levels, out of five, that are left out for a first look. The grid then has 129
/// nodes along a side.
inline constexpr int kCoarseLevelsLeftOut = 2;

/// Computes mountains in balance between uplift and the rivers that cut them. Valleys join on
/// their way to the outlets, and ridges divide them. The stream power law in its steady state
/// gives the slope, which is at most `steepest`:
///   slope = k uplift / discharge^concavity
/// It is solved over the drainage tree as in Cordonnier et al., "Large scale terrain generation
/// from tectonic uplift and fluvial erosion" (2016). Basins are filled by priority flood (Barnes
/// et al. 2014). k is chosen to reach `height_m`, and the result is scaled to meet it. `bedrock`
/// fills one entry for each point. If it names no outlet, the first corner is one. Every other
/// node lies above one of its neighbours. All cores are used, and the bits do not depend on their
/// number.
HeightGrid carve_valleys(const DrainageOptions& options,
                         const std::function<void(const Points&, Bedrock*)>& bedrock);

}  // namespace aerostat::terrain
