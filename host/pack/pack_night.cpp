#include "pack/pack_night.hpp"

#include <algorithm>
#include <cmath>

#include "core/copy.hpp"
#include "pack/pack_air.hpp"
#include "pack/star_catalogue.hpp"
#include "pack/star_cells.hpp"
#include "scene/celestial.hpp"
#include "scene/key_light.hpp"
#include "scene/moonlight.hpp"
#include "scene/pixel_size.hpp"
#include "scene/scene.hpp"

namespace aerostat::pack {
namespace {

constexpr dvec3 kLuminance{0.2126, 0.7152, 0.0722};
constexpr double kSunMagnitude = -26.74;
// Stars are not seen by a higher sun.
constexpr double kStarSunDeg = -3.0;
// The spread of a star's blur in pixels, and its limits in radians. Chosen by eye.
constexpr double kStarPixels = 0.55, kLeastSpread = 1e-5, kMostSpread = 5e-3;
// A star is drawn as a Gaussian, which is cut off at this many standard deviations. There it has
// fallen to exp(-0.5 * 3.6^2) = 0.0015 of its maximum.
constexpr double kStarReach = 3.6;
// The most by which the disc of the moon is brighter at night than white paper on the ground. An
// eye adapts to both, and a film that is exposed for the land would show the disc white. Chosen by
// eye.
constexpr double kMoonOverPaper = 45.0;
// The luminance of the brightest part of the Milky Way in cd/m^2, and the illuminance of the sun
// outside the air in lx.
constexpr double kMilkyWay = 5e-4, kSunLux = 133100.0;

/// Returns the share of light that a ball of Lommel and Seeliger's law reflects to the Earth at a
/// phase, of what it reflects when full.
double lommel_seeliger_phase(double phase_rad) {
  const double half = 0.5 * phase_rad;
  if (half < 1e-6) return 1.0;
  return 1.0 - std::sin(half) * std::tan(half) * std::log(1.0 / std::tan(0.5 * half));
}

/// Returns the radiance of white paper that lies on the ground.
double paper_radiance(const scene::KeyLight& key, const air::Light& light) {
  const double sine = std::max(key.direction.y, 0.0);
  const dvec3 through =
      glm::exp(-(light.depth_molecules + light.depth_haze + light.depth_ozone)) * sine;
  const dvec3 sky = glm::max(light.ambient[0] + light.ambient[1], dvec3(0.0));
  return glm::dot(key.irradiance * (through / std::numbers::pi + sky), kLuminance);
}

AeroMoon pack_moon(const scene::Scene& scene, const air::Light& light, const dvec3& pole,
                   double pixel) {
  AeroMoon packed{};
  const scene::Moon& moon = scene.moon;
  if (!moon.enabled) return packed;
  const dvec3 direction = scene::moon_direction(moon);
  const scene::MoonPhase phase =
      scene::moon_phase(direction, moon.distance_km, glm::normalize(scene.sun.direction));
  const dvec3 across = glm::cross(direction, pole);
  const dvec3 right = glm::length(across) < 1e-6 ? dvec3(1.0, 0.0, 0.0) : glm::normalize(across);
  copy(packed.direction, direction);
  copy(packed.right, right);
  copy(packed.up, glm::cross(right, direction));
  copy(packed.to_sun, phase.to_sun);
  const double radius = std::asin(scene::kMoonRadiusKm / moon.distance_km);
  const dvec3 irradiance = dvec3(scene.sun.color) * scene.sun.irradiance *
                           scene::moon_share_of_sun(phase.phase_rad, moon.distance_km);
  const double thin = std::max(lommel_seeliger_phase(phase.phase_rad), 1e-3);
  const dvec3 radiance = irradiance / (std::numbers::pi * radius * radius * thin);
  const double most = kMoonOverPaper * paper_radiance(scene::key_light(scene), light);
  const double shown = std::min(1.0, most / std::max(glm::dot(radiance, kLuminance), 1e-300));
  copy(packed.radiance, radiance * shown);
  packed.radius = static_cast<float>(radius);
  packed.soft = static_cast<float>(std::clamp(0.7 * pixel, 0.004 * radius, 0.5 * radius));
  // A full Earth is about 40 times as bright as a full moon. Its light makes the dark part about a
  // ten-thousandth as bright as the sunlit one.
  packed.earthlight = static_cast<float>(1e-4 * (1.0 - phase.lit_share));
  return packed;
}

std::array<dvec3, 3> galaxy_rows(const std::array<dvec3, 3>& equator) {
  // Source: "The Hipparcos and Tycho Catalogues", ESA SP-1200 (1997), volume 1, equation 1.5.11.
  constexpr dvec3 kGalaxy[] = {{-0.0548755604, -0.8734370902, -0.4838350155},
                               {0.4941094279, -0.4448296300, 0.7469822445},
                               {-0.8676661490, -0.1980763734, 0.4559837762}};
  std::array<dvec3, 3> rows{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) rows[i] += kGalaxy[i][k] * equator[static_cast<std::size_t>(k)];
  }
  return rows;
}

void copy_rows(float (&to)[9], const std::array<dvec3, 3>& rows) {
  for (std::size_t i = 0; i < 9; ++i)
    to[i] = static_cast<float>(rows[i / 3][static_cast<int>(i % 3)]);
}

/// Returns the stars of the catalogue with the radiance in the middle of a blur of this spread.
std::vector<AeroStar> lit_stars(const scene::Sun& sun, double spread) {
  std::vector<AeroStar> stars;
  const dvec3 brightest =
      dvec3(sun.color) * sun.irradiance / (2.0 * std::numbers::pi * spread * spread);
  for (const Star& star : star_catalogue()) {
    AeroStar packed{};
    copy(packed.direction, star.direction);
    const double share = std::pow(10.0, -0.4 * (star.magnitude - kSunMagnitude));
    copy(packed.radiance, brightest * star_hue(star.color_index) * share);
    stars.push_back(packed);
  }
  return stars;
}

AeroStars pack_stars(const scene::Scene& scene, double pixel, std::vector<AeroSkyCell>& sky_table) {
  AeroStars packed{};
  const double sun_deg = std::asin(glm::normalize(scene.sun.direction).y) / scene::detail::kDegree;
  if (!scene.stars.enabled || sun_deg > kStarSunDeg) return packed;
  const auto rows =
      equator_rows(scene.stars.sidereal_deg, scene.stars.latitude_deg, scene.stars.year);
  copy_rows(packed.equator, rows);
  copy_rows(packed.galaxy, galaxy_rows(rows));
  const double spread = std::clamp(kStarPixels * pixel, kLeastSpread, kMostSpread);
  packed.reach = static_cast<float>(kStarReach * spread);
  packed.sharpness = static_cast<float>(0.5 / (spread * spread));
  packed.pixel = static_cast<float>(std::max(pixel, kLeastSpread));
  packed.milky_way =
      static_cast<float>(scene.stars.milky_way * scene.sun.irradiance * kMilkyWay / kSunLux);
  append_stars(lit_stars(scene.sun, spread), kStarReach * spread, packed, sky_table);
  return packed;
}

}  // namespace

std::array<dvec3, 3> equator_rows(double sidereal_deg, double latitude_deg, double year) {
  using scene::detail::Equatorial;
  using scene::detail::kDegree;
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  // The axes of the equator of the year, as they stand in the scene.
  const dvec3 x = scene::detail::seen_from(Equatorial{0.0, 0.0}, sidereal_deg, latitude_deg);
  const dvec3 y = scene::detail::seen_from(Equatorial{kQuarter, 0.0}, sidereal_deg, latitude_deg);
  const dvec3 z = scene::detail::seen_from(Equatorial{0.0, kQuarter}, sidereal_deg, latitude_deg);
  // Precession from 2000: J. Meeus, "Astronomical Algorithms" (2nd ed., 1998), formulas 21.3 and
  // 21.4, as three turns.
  const double t = (year - 2000.0) / 100.0;
  const double first = t * (2306.2181 + t * 0.30188) / 3600.0 * kDegree;
  const double last = t * (2306.2181 + t * 1.09468) / 3600.0 * kDegree;
  const double tilt = t * (2004.3109 - t * 0.42665) / 3600.0 * kDegree;
  const auto about_pole = [](const std::array<dvec3, 3>& a, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return std::array<dvec3, 3>{a[0] * c + a[1] * s, a[1] * c - a[0] * s, a[2]};
  };
  // These are the inverse turns, from the year back to 2000, of the axes.
  std::array<dvec3, 3> axes = about_pole({x, y, z}, last);
  const double c = std::cos(tilt), s = std::sin(tilt);
  axes = {axes[0] * c + axes[2] * s, axes[1], axes[2] * c - axes[0] * s};
  return about_pole(axes, first);
}

AeroNight pack_night(const scene::ResolvedScene& scene, const air::Light& light,
                     std::vector<AeroSkyCell>& sky_table) {
  AeroNight night{};
  if (light.afterglow) {
    const std::vector<AeroSkyCell> glow = pack_sky_table(*light.afterglow);
    sky_table.insert(sky_table.end(), glow.begin(), glow.end());
    night.glowing = 1u;
    copy(night.glow_direction, glm::normalize(scene->sun.direction));
    copy(night.glow_irradiance, dvec3(scene->sun.color) * scene->sun.irradiance);
  }
  const double pixel = scene::pixel_size(*scene).angle_rad;
  const dvec3 pole = equator_rows(0.0, scene->stars.latitude_deg, 2000.0)[2];
  night.moon = pack_moon(*scene, light, pole, pixel);
  night.stars = pack_stars(*scene, pixel, sky_table);
  const air::FogLayer& fog = light.atmosphere.fog;
  const double over = (scene.eye().y - fog.top) / fog.softness;
  const double above = std::log1p(std::exp(-std::abs(over))) + std::max(-over, 0.0);
  copy(night.depth, light.depth_above + dvec3(fog.extinction * fog.softness * above));
  return night;
}

}  // namespace aerostat::pack
