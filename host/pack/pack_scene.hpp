#pragma once

#include <memory>

#include "air/light.hpp"
#include "bvh/bvh.hpp"
#include "camera.h"
#include "pack/cloud_chart.hpp"
#include "scene/scene.hpp"
#include "scene_params.h"

namespace aerostat::pack {

/// Light, air, materials and ground rules; too much of it for a thread's stack. Throws
/// Error{bad_data} for more than AERO_MAX_POINT_LIGHTS point lights.
std::unique_ptr<AeroScene> pack_scene(const scene::Scene& scene);

/// What packing a scene keeps for the next one.
struct PackCache {
  air::ScatteringCache air;
  CloudChartCache clouds;
};

/// Packs a scene with what a cache has of the air and the clouds, and leaves its own there.
std::unique_ptr<AeroScene> pack_scene(const scene::Scene& scene, PackCache& cache);

/// Camera, image size and sampling. Parallel rays begin shortly before `world`, the bounds of all
/// that they can meet, if the eye is far away from it: single precision would bend them. Throws
/// Error{bad_data} if the camera's target is its position.
AeroFrame pack_frame(const scene::Scene& scene, const bvh::Bounds& world = {});

}  // namespace aerostat::pack
