#include "air/scattering.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

namespace aerostat::air {
namespace {

constexpr double kPi64 = std::numbers::pi;
constexpr double kEven = 1.0 / (4.0 * kPi64);

// Heights go by squares up to kHighest. The air that one eye sees reaches a tenth of a right angle
// or so around the planet: the cosine of the sun stays near its own.
constexpr int kHeights = 16, kSuns = 8;
constexpr double kHighest = 60e3, kSunReach = 0.2;
constexpr int kRings = 8, kSectors = 4, kSteps = 20;
// Of what light a scattering sends on in the same place at most; the sum of all orders is finite.
constexpr double kMostKept = 0.97;

/// A direction of a sphere of rings of equal area, half of it: the sun's plane is a mirror.
dvec3 sphere_direction(int ring, int sector) {
  const double y = 1.0 - (2.0 * ring + 1.0) / kRings;
  const double level = std::sqrt(1.0 - y * y);
  const double azimuth = kPi64 * (sector + 0.5) / kSectors;
  return {level * std::cos(azimuth), y, level * std::sin(azimuth)};
}

/// Calls `visit(share, mean, height, sun_cosine)` for each step: share is what of an even source in
/// it arrives at the start, per extinction. Returns the transmittance of the way.
template <class Visit>
dvec3 march(const Atmosphere& air, const dvec3& sun, const Way& way, int steps,
            const Visit& visit) {
  dvec3 through(1.0);
  double before = 0.0, low = way.height;
  const double start = kGroundRadius + way.height;
  const double climb = glm::dot(way.direction, sun);
  for (int i = 1; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const double now = way.length * part * part;
    const double high = height_after(way.height, way.direction.y, now);
    const Density mean = air.mean_density(low, high);
    const dvec3 extinction = air.extinction(mean);
    const dvec3 here = glm::exp(-extinction * (now - before));
    const double middle = 0.5 * (before + now);
    const double height = height_after(way.height, way.direction.y, middle);
    const double sun_cosine = (start * sun.y + middle * climb) / (kGroundRadius + height);
    visit(through * (1.0 - here) / glm::max(extinction, dvec3(1e-30)), mean, height, sun_cosine);
    through *= here;
    before = now;
    low = high;
  }
  return through;
}

/// Light of a source that is even in direction: what two scatterings bring, then all that follow as
/// a geometric series of the share that one more scattering keeps.
dvec3 light_around(const Atmosphere& air, const SunPaths& paths, double height, double sun_cosine) {
  const dvec3 sun{std::sqrt(std::max(0.0, 1.0 - sun_cosine * sun_cosine)), sun_cosine, 0.0};
  dvec3 second(0.0), kept(0.0);
  for (int i = 0; i < kRings * kSectors; ++i) {
    Way way{height, sphere_direction(i / kSectors, i % kSectors), 0.0};
    way.length = way_to_the_end(height, way.direction.y);
    const dvec3 through = march(
        air, sun, way, kSteps,
        [&](const dvec3& share, const Density& mean, double at, double cosine) {
          const dvec3 scattered = share * air.scattering(mean);
          kept += scattered;
          second += scattered * kEven * sun_share(at, cosine) * paths.transmittance(at, cosine);
        });
    if (!meets_ground(height, way.direction.y)) continue;
    const dvec3 end = dvec3(0.0, kGroundRadius + height, 0.0) + way.length * way.direction;
    const double cosine = glm::dot(glm::normalize(end), sun);
    second += through * air.ground_albedo / kPi64 * std::max(cosine, 0.0) *
              paths.transmittance(0.0, cosine);
  }
  const double directions = kRings * kSectors;
  return second / directions / (1.0 - glm::min(kept / directions, dvec3(kMostKept)));
}

}  // namespace

bool meets_ground(double height, double cosine) {
  return cosine < 0.0 && std::isfinite(distance_to_height(std::max(height, 0.0), cosine, 0.0));
}

double way_to_the_end(double height, double cosine) {
  const double h = std::clamp(height, 0.0, kTopHeight);
  return distance_to_height(h, cosine, meets_ground(h, cosine) ? 0.0 : kTopHeight);
}

double fog_glow(double sun_cosine) {
  const double mu = std::max(sun_cosine, 0.0);
  return 3.0 * kEven * mu * (mu + 2.0 / 3.0);
}

Scattering::Scattering(const Atmosphere& air, const dvec3& sun)
    : air_(air), paths_(air), sun_(sun), around_(kHeights * kSuns) {
  // Fog is too thin a layer for the light of all the air.
  Atmosphere clear = air;
  clear.fog = {};
  tbb::parallel_for(0, kHeights * kSuns, [&](int i) {
    const double root = static_cast<double>(i / kSuns) / (kHeights - 1);
    const double share = static_cast<double>(i % kSuns) / (kSuns - 1);
    const double cosine = std::clamp(sun_.y + kSunReach * (2.0 * share - 1.0), -1.0, 1.0);
    around_[static_cast<std::size_t>(i)] =
        light_around(clear, paths_, kHighest * root * root, cosine);
  });
}

dvec3 Scattering::sunlight(double height, double sun_cosine) const {
  return paths_.transmittance(height, sun_cosine) *
         (sun_share(height, sun_cosine) * fog_light(air_.fog, height, sun_cosine));
}

dvec3 Scattering::around(double height, double sun_cosine) const {
  const double row = std::sqrt(std::clamp(height / kHighest, 0.0, 1.0)) * (kHeights - 1);
  const double column =
      std::clamp(0.5 + 0.5 * (sun_cosine - sun_.y) / kSunReach, 0.0, 1.0) * (kSuns - 1);
  const int i = std::min(static_cast<int>(row), kHeights - 2);
  const int j = std::min(static_cast<int>(column), kSuns - 2);
  const dvec3* low = around_.data() + i * kSuns + j;
  const dvec3* high = low + kSuns;
  return glm::mix(glm::mix(low[0], low[1], column - j), glm::mix(high[0], high[1], column - j),
                  row - i);
}

PathLight Scattering::follow(const Way& way, int steps) const {
  const double towards = glm::dot(way.direction, sun_);
  const double molecules = rayleigh_phase(towards);
  const double fog = fog_glow(sun_.y) + kFogDirect * haze_phase(towards, kFogAsymmetry);
  PathLight light;
  light.transmittance =
      march(air_, sun_, way, steps,
            [&](const dvec3& share, const Density& mean, double height, double sun_cosine) {
              const dvec3 sun = sunlight(height, sun_cosine);
              const dvec3 single = sun * (air_.molecules * (mean.molecules * molecules) +
                                          air_.fog.extinction * mean.fog * fog);
              light.add += share * (single + around(height, sun_cosine) * air_.scattering(mean));
              light.haze += share * sun * air_.haze_scattering * mean.haze;
            });
  return light;
}

}  // namespace aerostat::air
