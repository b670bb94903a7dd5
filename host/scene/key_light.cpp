#include "scene/key_light.hpp"

#include <cmath>

#include "scene/moonlight.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene {

KeyLight key_light(const Scene& scene) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  const dvec3 sun = glm::normalize(scene.sun.direction);
  KeyLight light{sun, dvec3(scene.sun.color) * scene.sun.irradiance, false};
  const Moon& moon = scene.moon;
  // A moon just below the horizon still shines on peaks.
  if (!moon.enabled || sun.y > std::sin(-4.0 * kDegree) || moon.elevation_deg < -2.0) return light;
  const dvec3 direction = moon_direction(moon);
  const MoonPhase phase = moon_phase(direction, moon.distance_km, sun);
  return {direction, light.irradiance * moon_share_of_sun(phase.phase_rad, moon.distance_km), true};
}

}  // namespace aerostat::scene
