#include "air/light.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

namespace aerostat::air {
namespace {

/// From where on a sun at this elevation is seen over the horizon; far down if it stands above it.
double height_of_sight(double elevation) {
  if (elevation >= 0.0) return -1e6;
  return kGroundRadius * (1.0 / std::cos(elevation) - 1.0);
}

/// Where the columns towards the sun are taken: among the heights of a landscape that see it.
double reference_height(double elevation) {
  return std::max(0.0, height_of_sight(elevation)) + 500.0;
}

/// The parabola through three values at 0, a and b.
std::array<dvec3, 3> parabola(const dvec3& f0, double a, const dvec3& fa, double b,
                              const dvec3& fb) {
  const dvec3 slope_a = (fa - f0) / a, slope_b = (fb - f0) / b;
  const dvec3 bend = (slope_b - slope_a) / (b - a);
  return {f0, slope_a - bend * a, bend};
}

/// The air of the last scene asked for: it knows no eye, and takes three times as long as the sky
/// that an eye sees.
std::shared_ptr<const Scattering> scattering_of(const scene::Scene& scene) {
  static std::mutex mutex;
  static std::shared_ptr<const Scattering> kept;
  const Atmosphere air = atmosphere_of(scene);
  const dvec3 sun = glm::normalize(scene.sun.direction);
  const std::lock_guard lock(mutex);
  if (!kept || kept->atmosphere() != air || kept->sun() != sun) {
    kept = std::make_shared<const Scattering>(air, sun);
  }
  return kept;
}

}  // namespace

Light::Light(const scene::Scene& scene) : Light(scene, *scattering_of(scene)) {}

Light::Light(const scene::Scene& scene, const Scattering& air)
    : atmosphere(air.atmosphere()), sky(air, scene.camera.position.y) {
  const double sun = air.sun().y;
  const double elevation = std::asin(std::clamp(sun, -1.0, 1.0));
  const double height = reference_height(elevation);
  const Columns way = air.sun_paths().columns(height, sun);
  // At the sea each column is longer by as much as the air is denser there.
  depth_molecules = atmosphere.molecules * way.molecules *
                    std::exp(std::min(height / atmosphere.molecules_height, 60.0));
  depth_haze = atmosphere.haze_extinction * way.haze *
               std::exp(std::min(height / atmosphere.haze_height, 60.0));
  depth_ozone = atmosphere.ozone * way.ozone;
  sun_heights[0] = height_of_sight(elevation + kSunRadius);
  sun_heights[1] = std::max(sun_heights[0] + 1.0, height_of_sight(elevation - kSunRadius));
  around = parabola(air.around(0.0, sun), 0.4 * kAroundTop, air.around(0.4 * kAroundTop, sun),
                    kAroundTop, air.around(kAroundTop, sun));
  ambient = ambient_light(sky);
}

}  // namespace aerostat::air
