#pragma once

#include "rimmed_grid.hpp"

namespace aerostat::terrain {

/// The direction of a node whose water runs to no other node.
inline constexpr std::uint8_t kNoReceiver = 8;

/// Returns for each node the direction of the neighbour that its water runs to. Only neighbours
/// that come before the node count: those that lie lower, or equally high and first in memory.
/// Among them, the water takes the steepest fall, weighted with some chance by `seed`. On a
/// regular grid, the steepest fall alone would give straight streams. Outlets and the rim have no
/// receiver. All cores are used.
Rimmed<std::uint8_t> receivers_by_height(const RimmedGrid& grid, const Rimmed<float>& heights,
                                         const Rimmed<std::uint8_t>& outlets, std::uint32_t seed);

/// Returns for each node the direction of the neighbour that its water runs to. Only neighbours
/// of lower rank count, however high they lie. The rank of the rim must be the largest. Otherwise
/// the function works like receivers_by_height.
Rimmed<std::uint8_t> receivers_by_rank(const RimmedGrid& grid, const Rimmed<float>& heights,
                                       const Rimmed<int>& ranks,
                                       const Rimmed<std::uint8_t>& outlets, std::uint32_t seed);

}  // namespace aerostat::terrain
