#include "scene/moonlight.hpp"

#include <algorithm>
#include <cmath>

#include "scene/light.hpp"
#include "scene/sun_angles.hpp"

namespace aerostat::scene {
namespace {

constexpr double kSunDistanceKm = 149597870.7;
constexpr double kSunMagnitude = -26.74;
// By Planck's law at 645, 550 and 442 nm, for the difference of 0.27 in B-V between moon and sun.
// The luminance is that of white.
constexpr dvec3 kMoonHue{1.106, 0.984, 0.807};
// Allen's formula holds up to this phase.
constexpr double kLastPhaseDeg = 150.0;

double lit_share_of(double phase_rad) {
  return 0.5 + 0.5 * std::cos(phase_rad);
}

}  // namespace

MoonPhase moon_phase(const dvec3& moon, double distance_km, const dvec3& sun) {
  const dvec3 way = sun * kSunDistanceKm - moon * distance_km;
  MoonPhase phase;
  phase.to_sun = glm::normalize(way);
  phase.phase_rad = std::acos(std::clamp(-glm::dot(phase.to_sun, moon), -1.0, 1.0));
  phase.lit_share = lit_share_of(phase.phase_rad);
  return phase;
}

double moon_magnitude(double phase_rad, double distance_km) {
  const double degrees = phase_rad * (180.0 / std::numbers::pi);
  const double known = std::min(degrees, kLastPhaseDeg);
  double magnitude = -12.73 + 0.026 * known + 4e-9 * std::pow(known, 4.0);
  if (degrees > known) {
    const double least = 1e-9;
    const double share = lit_share_of(phase_rad) / lit_share_of(known * std::numbers::pi / 180.0);
    magnitude -= 2.5 * std::log10(std::max(share, least));
  }
  return magnitude + 5.0 * std::log10(distance_km / kMeanMoonDistanceKm);
}

dvec3 moon_share_of_sun(double phase_rad, double distance_km) {
  const double dimmer = moon_magnitude(phase_rad, distance_km) - kSunMagnitude;
  return kMoonHue * std::pow(10.0, -0.4 * dimmer);
}

dvec3 moon_direction(const Moon& moon) {
  return detail::direction_of({moon.azimuth_deg, moon.elevation_deg});
}

}  // namespace aerostat::scene
