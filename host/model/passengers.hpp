#pragma once

#include "mesh/mesh.hpp"
#include "model/detail.hpp"

namespace aerostat::model {

/// The most passengers that stand in the basket.
inline constexpr int kMostPassengers = 3;

/// Builds simple figures that stand in the basket, in its coordinates (dimensions.hpp): one at each
/// side and one at the back, beside and behind the eye of the view from the basket. They look out
/// and wave. `count` is 0 to kMostPassengers.
mesh::TriangleMesh build_passengers(int count, const Detail& detail = {});

}  // namespace aerostat::model
