#pragma once

#include "rimmed_grid.hpp"

namespace aerostat::terrain {

/// The order in which water that rises evenly from the outlets reaches the nodes, by node; water
/// that flows over into a basin fills it first. Ties go to the node that lies first. Places of the
/// rim, and nodes that no outlet reaches, come last with equal ranks. Priority flood (Barnes et al.
/// 2014); what waits for the water's level lies in a set over the sorted heights rather than in a
/// heap. On one core.
Rimmed<int> flood_ranks(const RimmedGrid& grid, const Rimmed<float>& heights,
                        const Rimmed<std::uint8_t>& outlets);

}  // namespace aerostat::terrain
