#pragma once

#include <cmath>

#include "pack/pack_scene.hpp"
#include "probe.hpp"

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
  scene.sky.sun_chord = 0.0045f;
  scene.air.molecules_height = 8400.0f;
  scene.air.haze_height = 1200.0f;
  scene.air.sun_heights[0] = -1e6f;
  scene.air.sun_heights[1] = -9e5f;
  scene.air.around_top = 9000.0f;
  scene.air.deck_sun = scene.air.deck_around = scene.air.deck_level = 1.0f;
  scene.shading = AERO_SHADING_PHONG;
  return scene;
}

/// Sets a sky whose irradiance / pi varies evenly from `down` (on a plane that faces down) to `up`.
inline void set_ambient(AeroScene& scene, const vec3& up, const vec3& down) {
  for (int i = 0; i < 3; ++i) {
    scene.air.ambient[0][i] = 0.5f * (up[i] + down[i]) / scene.sky.sun_irradiance[i];
    scene.air.ambient[1][i] = 0.5f * (up[i] - down[i]) / scene.sky.sun_irradiance[i];
    scene.air.above_clouds[i] = up[i] / scene.sky.sun_irradiance[i];
    scene.air.below_clouds[i] = down[i] / scene.sky.sun_irradiance[i];
  }
}

inline opencl::Buffer<AeroScene> uploaded(const AeroScene& scene) {
  return input(std::vector<AeroScene>{scene});
}

/// Returns a scene whose sky has the same radiance in all directions, without a chart of clouds.
/// `radiance` is per irradiance of the sun.
inline pack::PackedScene with_even_sky(const AeroScene& scene, const vec3& radiance = vec3(0.0f)) {
  AeroSkyCell cell{};
  set3(cell.add, radiance);
  return {scene, std::vector<AeroSkyCell>(AERO_SKY_CELLS, cell), nullptr};
}

/// The buffers of a scene, in the order in which probes with a SceneView take them.
struct UploadedScene {
  explicit UploadedScene(const pack::PackedScene& scene)
      : numbers(uploaded(scene.numbers)), sky_table(input(scene.sky_table)) {
    if (scene.cloud_chart) cloud_chart = input(scene.cloud_chart->words);
  }

  opencl::Buffer<AeroScene> numbers;
  opencl::Buffer<AeroSkyCell> sky_table;
  opencl::Buffer<AeroChartWord> cloud_chart;
};

/// Returns the unit vector in the plane of y and x that is `degrees` away from +y.
inline vec3 tilted(float degrees) {
  const float a = radians_from_degrees(degrees);
  return {std::sin(a), std::cos(a), 0.0f};
}

}  // namespace aerostat::test
