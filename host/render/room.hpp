#pragma once

#include "scene/scene.hpp"

namespace aerostat::render {

/// Throws Error{exhausted} if the ground of `scene`, its tree and the intermediate data need more
/// memory than the process can have. A process that exceeds the limit of a container would be
/// killed without a message. The need is estimated from measurements.
void require_room_for_land(const scene::Scene& scene);

}  // namespace aerostat::render
