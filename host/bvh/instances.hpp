#pragma once

#include <span>

#include "bvh.hpp"

namespace aerostat::bvh {

/// Builds a tree over instances of models. Leaf k stands for instance k, whose box in the world
/// is bounds[k]. The tree has no slots. All cores work on it, and the result does not depend on
/// their number. Throws Error{bad_data} if there are more than 2^27 instances or if a box is
/// empty or not finite.
Bvh build_instances(std::span<const Bounds> bounds);

}  // namespace aerostat::bvh
