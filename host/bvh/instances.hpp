#pragma once

#include <span>

#include "bvh.hpp"

namespace aerostat::bvh {

/// A tree over instances of models: leaf k stands for instance k, whose box in the world is
/// bounds[k]. It has no slots. Runs on all cores and gives the same tree on any number of them.
/// Throws Error{bad_data} if there are more than 2^27 or a box is empty or not finite.
Bvh build_instances(std::span<const Bounds> bounds);

}  // namespace aerostat::bvh
