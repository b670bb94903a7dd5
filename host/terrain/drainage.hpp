#pragma once

#include <cstdint>
#include <functional>

#include "height_grid.hpp"

namespace aerostat::terrain {

/// What the ground is like at a point, for the relief that rivers cut.
struct Bedrock {
  float uplift = 1.0f;    // relative rate, >= 0; more of it makes steeper, higher ground
  float steepest = 0.8f;  // tangent at which slopes fail
  float outlet_m = 0.0f;  // height, if it is an outlet
  bool outlet = false;    // rivers end here
};

struct DrainageOptions {
  int coarse_nodes = 33;                         // per side, at the first level
  std::vector<int> rounds = {20, 14, 10, 6, 3};  // per level; each level doubles the resolution
  int levels_left_out = 0;                       // of the last ones
  double size_m = 40000.0;
  double height_m = 2400.0;     // one point in a thousand is higher
  float concavity = 0.5f;       // slope ~ area^-concavity
  float floor_m = 60.0f;        // half width of the flat floor of a valley that drains 1 km^2
  float floor_growth = 0.4f;    // the width grows with area^floor_growth
  float floor_area_km2 = 1.5f;  // smaller valleys have no floor
  std::uint32_t seed = 1;
};

/// Of five: a grid of 129 nodes a side for a first look.
inline constexpr int kCoarseLevelsLeftOut = 2;

/// Mountains in balance between uplift and the rivers that cut them: valleys join on their way to
/// the outlets, ridges divide them. Stream power law in its steady state,
///     slope = k uplift / discharge^concavity, at most `steepest`,
/// solved over the drainage tree as in Cordonnier et al., "Large scale terrain generation from
/// tectonic uplift and fluvial erosion" (2016), basins filled by priority flood (Barnes et al.
/// 2014). k is chosen to reach `height_m`, and the result scaled to meet it; `bedrock` fills one
/// entry per point. Where it names no outlet at all, the first corner is one. Every other node lies
/// above one of its neighbours. Runs on all cores; the bits do not depend on how many.
HeightGrid carve_valleys(const DrainageOptions& options,
                         const std::function<void(const Points&, Bedrock*)>& bedrock);

}  // namespace aerostat::terrain
