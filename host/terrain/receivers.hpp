#pragma once

#include "rimmed_grid.hpp"

namespace aerostat::terrain {

/// The direction of nodes whose water goes nowhere.
inline constexpr std::uint8_t kNoReceiver = 8;

/// Where the water of each node runs: the direction of the neighbour to which the ground falls most
/// steeply, with a share of chance by `seed`, because streams bend: on a regular grid the steepest
/// one alone gives straight lines. Only neighbours that come before the node count: those that lie
/// lower, or equally high and first in memory. Outlets have none, nor has the rim. On all cores.
Rimmed<std::uint8_t> receivers_by_height(const RimmedGrid& grid, const Rimmed<float>& heights,
                                         const Rimmed<std::uint8_t>& outlets, std::uint32_t seed);

/// The same where those count whose rank is less, however high they lie. The rim's is the largest.
Rimmed<std::uint8_t> receivers_by_rank(const RimmedGrid& grid, const Rimmed<float>& heights,
                                       const Rimmed<int>& ranks,
                                       const Rimmed<std::uint8_t>& outlets, std::uint32_t seed);

}  // namespace aerostat::terrain
