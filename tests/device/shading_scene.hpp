#pragma once

#include <cmath>

#include "probe.hpp"
#include "scene_params.h"

/// Provides a scene for the shading probes: a white sun straight above, no air, and no point
/// lights.
namespace aerostat::test {

inline void set3(aero_float* to, const vec3& from) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

inline AeroScene bare_scene() {
  AeroScene scene{};
  set3(scene.sky.sun_direction, {0, 1, 0});
  set3(scene.sky.sun_irradiance, vec3(kPi));
  scene.sky.sun_cos = 0.99999f;
  scene.air.molecules_height = 8400.0f;
  scene.air.haze_height = 1200.0f;
  scene.air.sun_heights[0] = -1e6f;
  scene.air.sun_heights[1] = -9e5f;
  scene.air.around_top = 9000.0f;
  scene.shading = AERO_SHADING_PHONG;
  return scene;
}

/// Sets a sky whose irradiance / pi varies evenly from `down` (on a plane that faces down) to `up`.
inline void set_ambient(AeroScene& scene, const vec3& up, const vec3& down) {
  for (int i = 0; i < 3; ++i) {
    scene.air.ambient[0][i] = 0.5f * (up[i] + down[i]) / scene.sky.sun_irradiance[i];
    scene.air.ambient[1][i] = 0.5f * (up[i] - down[i]) / scene.sky.sun_irradiance[i];
  }
}

inline opencl::Buffer<AeroScene> uploaded(const AeroScene& scene) {
  return input(std::vector<AeroScene>{scene});
}

/// Returns the unit vector in the plane of y and x that is `degrees` away from +y.
inline vec3 tilted(float degrees) {
  const float a = radians_from_degrees(degrees);
  return {std::sin(a), std::cos(a), 0.0f};
}

}  // namespace aerostat::test
