#pragma once

#include "probe.hpp"
#include "scene_params.h"

/// A scene for the shading probes: a white sun straight above, no sky light, no point lights.
namespace aerostat::test {

inline void set3(aero_float* to, const vec3& from) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

inline AeroScene bare_scene() {
  AeroScene scene{};
  set3(scene.sky.sun_direction, {0, 1, 0});
  set3(scene.sky.sun_irradiance, vec3(kPi));
  scene.sky.sun_cos = 0.99999f;
  scene.sky.haze_extinction = 4e-5f;
  scene.sky.haze_height = 1200.0f;
  scene.shading = AERO_SHADING_PHONG;
  return scene;
}

inline opencl::Buffer<AeroScene> uploaded(const AeroScene& scene) {
  return input(std::vector<AeroScene>{scene});
}

/// Unit vector in the plane of y and x, `degrees` away from +y.
inline vec3 tilted(float degrees) {
  const float a = radians_from_degrees(degrees);
  return {std::sin(a), std::cos(a), 0.0f};
}

}  // namespace aerostat::test
