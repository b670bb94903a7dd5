#pragma once

#include "rimmed_grid.hpp"

namespace aerostat::terrain {

/// Returns for each node the order in which water that rises evenly from the outlets reaches it.
/// Water that overflows into a basin fills the basin first. Among nodes that are reached
/// together, the first in memory comes first. Places of the rim, and nodes that no outlet
/// reaches, come last with equal ranks. The method is priority flood (Barnes et al. 2014), with a
/// set over the sorted heights in place of a heap. It runs on one core.
Rimmed<int> flood_ranks(const RimmedGrid& grid, const Rimmed<float>& heights,
                        const Rimmed<std::uint8_t>& outlets);

}  // namespace aerostat::terrain
