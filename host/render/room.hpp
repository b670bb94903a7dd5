#pragma once

#include "scene/scene.hpp"

namespace aerostat::render {

/// Throws Error{exhausted} if the ground of `scene`, its tree and what is built on the way need
/// more memory than the process can have: where a container's limit is met, it would be killed
/// without a word. The need is estimated by what was measured.
void require_room_for_land(const scene::Scene& scene);

}  // namespace aerostat::render
