#pragma once

#include "pack/pack_geometry.hpp"

namespace aerostat::pack {

/// Builds the trees of the models and the one over the instances, as pack_shape does.
Packed pack_instances(const world::Instances& instances, const Room& more);

}  // namespace aerostat::pack
