#pragma once

#include <memory>

#include "bvh/bvh.hpp"
#include "camera.h"
#include "scene/scene.hpp"
#include "scene_params.h"

namespace aerostat::pack {

/// Light, air, materials and ground rules; too much of it for a thread's stack. Throws
/// Error{bad_data} for more than AERO_MAX_POINT_LIGHTS point lights.
std::unique_ptr<AeroScene> pack_scene(const scene::Scene& scene);

/// Camera, image size and sampling. Parallel rays begin shortly before `world`, the bounds of all
/// that they can meet, if the eye is far away from it: single precision would bend them. Throws
/// Error{bad_data} if the camera's target is its position.
AeroFrame pack_frame(const scene::Scene& scene, const bvh::Bounds& world = {});

}  // namespace aerostat::pack
