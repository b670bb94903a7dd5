#pragma once

#include <vector>

#include "instance.h"
#include "pack/pack_geometry.hpp"
#include "world/world.hpp"

namespace aerostat::pack {

/// Plants as the kernels meet them.
struct PackedPlants {
  std::vector<bvh::Bvh> models;         // a tree each; `order` is given up
  PackedArrays arrays;                  // of the models, one after the other
  bvh::Bvh tree;                        // over the instances
  std::vector<AeroInstance> instances;  // `root` is the number of the model
};

/// Builds the trees of the models and the one over the instances. Runs on all cores.
PackedPlants pack_plants(const world::Plants& plants);

}  // namespace aerostat::pack
