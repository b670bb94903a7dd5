#include "air/light.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/smooth_step.hpp"
#include "scene/key_light.hpp"
#include "scene/scene.hpp"

namespace aerostat::air {
namespace {

constexpr double kPi64 = std::numbers::pi;

/// The light that diffuses in a level deck under a sun straight above, relative to that of a heap.
/// Found by comparing slabs with spheres (tests/device/atmosphere/droplets_test.cpp).
constexpr double kLevelDeck = 1.8;

/// Returns the height from which a sun at this elevation is seen over the horizon. Returns a
/// height far below the ground if the sun is above the horizon.
double height_of_sight(double elevation) {
  if (elevation >= 0.0) return -1e6;
  return kGroundRadius * (1.0 / std::cos(elevation) - 1.0);
}

/// Returns the height at which the columns towards the sun are taken. It is among the heights of
/// a landscape that see the sun.
double reference_height(double elevation) {
  return std::max(0.0, height_of_sight(elevation)) + 500.0;
}

/// Returns the height at which the columns of haze towards the sun are taken. It is inside the
/// haze.
double haze_reference_height(double elevation, double haze_height) {
  return std::max(0.0, height_of_sight(elevation)) + std::min(500.0, 0.5 * haze_height);
}

/// Returns the coefficients of the parabola through three values at 0, a and b.
std::array<dvec3, 3> parabola(const dvec3& f0, double a, const dvec3& fa, double b,
                              const dvec3& fb) {
  const dvec3 slope_a = (fa - f0) / a, slope_b = (fb - f0) / b;
  const dvec3 bend = (slope_b - slope_a) / (b - a);
  return {f0, slope_a - bend * a, bend};
}

std::shared_ptr<const Scattering> scattering_of(const scene::Scene& scene, const dvec3& sun,
                                                ScatteringCache::Last& cache) {
  const Atmosphere air = atmosphere_of(scene);
  return cache.get({air, sun}, [&] { return std::make_shared<const Scattering>(air, sun); });
}

/// Returns a / b, or 0 where b is 0.
dvec3 ratio(const dvec3& a, const dvec3& b) {
  dvec3 result(0.0);
  for (int i = 0; i < 3; ++i) {
    if (b[i] > 0.0) result[i] = a[i] / b[i];
  }
  return result;
}

}  // namespace

Light::Light(const scene::ResolvedScene& scene)
    : Light(scene, *std::make_unique<ScatteringCache>()) {}

Light::Light(const scene::ResolvedScene& scene, ScatteringCache& cache)
    : Light(scene.eye().y, cloud_deck_of(*scene),
            *scattering_of(*scene, scene::key_light(*scene).direction, cache.key)) {
  const scene::KeyLight key = scene::key_light(*scene);
  if (!key.is_moon) return;
  const dvec3 sun = glm::normalize(scene->sun.direction);
  const dvec3 strength = dvec3(scene->sun.color) * scene->sun.irradiance;
  add_afterglow(*scattering_of(*scene, sun, cache.afterglow), cloud_deck_of(*scene), scene.eye().y,
                ratio(strength, key.irradiance));
}

Light::Light(double eye_height, const CloudDeck& deck, const Scattering& air)
    : atmosphere(air.atmosphere()), sky(air, eye_height) {
  const double sun = air.sun().y;
  const double elevation = std::asin(std::clamp(sun, -1.0, 1.0));
  const double height = reference_height(elevation);
  const Columns way = air.sun_paths().columns(height, sun);
  const double haze_from = haze_reference_height(elevation, atmosphere.haze_height);
  // The depths hold at the sea, where the air is denser than at the height of the columns by
  // these factors.
  depth_molecules = atmosphere.molecules * way.molecules *
                    std::exp(std::min(height / atmosphere.molecules_height, 60.0));
  depth_haze = atmosphere.haze_extinction * air.sun_paths().columns(haze_from, sun).haze *
               std::exp(std::min(haze_from / atmosphere.haze_height, 60.0));
  scattered_depth_haze =
      depth_haze * (1.0 - air.thick_share() * (1.0 - reduced_haze_share(atmosphere)));
  depth_ozone = atmosphere.ozone * way.ozone;
  sun_heights[0] = height_of_sight(elevation + kSunRadius);
  sun_heights[1] = std::max(sun_heights[0] + 1.0, height_of_sight(elevation - kSunRadius));
  take_around(air, eye_height);
  take_clouds(deck, air, eye_height);
  depth_above = air.sun_paths().depth(std::max(eye_height, 0.0), 1.0, atmosphere.haze_extinction);
}

void Light::add_afterglow(const Scattering& air, const CloudDeck& deck, double eye_height,
                          const dvec3& sun_over_moon) {
  const Light glow(eye_height, deck, air);
  for (std::size_t i = 0; i < 3; ++i) {
    around[i] += glow.around[i] * sun_over_moon;
    around_slant[i] += glow.around_slant[i] * sun_over_moon;
  }
  around_least += glow.around_least * sun_over_moon;
  for (std::size_t i = 0; i < 9; ++i) ambient[i] += glow.ambient[i] * sun_over_moon;
  above_clouds += glow.above_clouds * sun_over_moon;
  below_clouds += glow.below_clouds * sun_over_moon;
  afterglow = glow.sky;
}

void Light::take_clouds(const CloudDeck& deck, const Scattering& air, double eye_height) {
  const double sun = std::max(air.sun().y, 0.0);
  const dvec3 level_light =
      sky.irradiance_from_above() + sun * air.sunlight(deck.base, air.sun().y);
  ambient = ambient_light(sky, deck, eye_height, level_light, atmosphere.ground_albedo);
  above_clouds = sky.irradiance_from_above() / kPi64;
  below_clouds =
      atmosphere.ground_albedo * deck.light_below(atmosphere.ground_albedo) * level_light / kPi64;
  // Between separate clouds, light comes to the air from the sides. Chosen by eye.
  const double closed = smooth_step(0.4, 0.9, deck.cover);
  deck_base = deck.base;
  deck_level = std::lerp(1.0, kLevelDeck * sun, closed);
  deck_sun = 1.0 - closed * (1.0 - deck.sun_below(air.sun().y));
  deck_around = 1.0 - closed * (1.0 - deck.light_below(atmosphere.ground_albedo).y);
}

void Light::take_around(const Scattering& air, double eye_height) {
  const double haze_height = atmosphere.haze_height;
  thick_haze = air.thick_share() > 0.0;
  double middle = 0.4 * kAroundTop, top = kAroundTop;
  const auto height_of = [&](double x) { return thick_haze ? -haze_height * std::log1p(-x) : x; };
  if (thick_haze) {
    // The parabola passes through the value at the eye, whose surroundings hide everything else.
    top = around_top = -std::expm1(-std::min(3.0, kAroundTop / haze_height));
    const double eye = -std::expm1(-std::max(eye_height, 0.0) / haze_height);
    middle = std::clamp(eye, 0.05 * top, 0.8 * top);
  }
  const double sun = air.sun().y;
  const HazeLight::Field low = air.around(0.0, sun), half = air.around(height_of(middle), sun),
                         high = air.around(height_of(top), sun);
  around = parabola(low.even, middle, half.even, top, high.even);
  around_slant = parabola(low.slant, middle, half.slant, top, high.slant);
  if (thick_haze) around_least = glm::min(glm::min(low.even, half.even), high.even);
}

}  // namespace aerostat::air
