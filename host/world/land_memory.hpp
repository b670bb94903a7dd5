#pragma once

#include "core/memory_left.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::world {

/// Throws Error{exhausted} if the ground of `scene`, its tree and what is built on the way need
/// more memory than `left`. Without this check, a process that reaches the limit of its container
/// is killed without a word. The need is estimated from measurements.
void require_memory_for_land(const scene::Scene& scene, const MemoryLeft& left = memory_left());

}  // namespace aerostat::world
