#include "air/scattering.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "core/smooth_step.hpp"

namespace aerostat::air {
namespace {

constexpr double kPi64 = std::numbers::pi;
constexpr double kEven = 1.0 / (4.0 * kPi64);

// The sizes of the table of light. The square roots of its heights, up to kHighest, are evenly
// spaced.
constexpr int kHeights = 16, kSuns = 8;
constexpr double kHighest = 60e3, kSunReach = HazeLight::kSunReach;
constexpr int kRings = 8, kSectors = 4, kSteps = 20;
// The largest share of light that a scattering may keep in the same place, so that the sum of all
// orders is finite.
constexpr double kMostKept = 0.97;

/// Returns a direction on a sphere of rings of equal area. Half of the sphere is enough, because
/// the light is symmetric about the plane of the sun.
dvec3 sphere_direction(int ring, int sector) {
  const double y = 1.0 - (2.0 * ring + 1.0) / kRings;
  const double level = std::sqrt(1.0 - y * y);
  const double azimuth = kPi64 * (sector + 0.5) / kSectors;
  return {level * std::cos(azimuth), y, level * std::sin(azimuth)};
}

/// Returns the mean place, as a share of a step, where the light that leaves the step at its
/// start was scattered. The step has the given optical depth. The place is right for sources that
/// change evenly along the step.
double mean_place(double depth) {
  return depth < 0.01 ? 0.5 - depth / 12.0 : 1.0 / depth - 1.0 / std::expm1(depth);
}

/// Calls `visit(share, mean, height, sun_cosine)` for each step of a path. `share` is the light
/// of an even source in the step that arrives at the start, per extinction. The height and the
/// cosine of the sun are those of the middle of the step. If steps `hide` their own ends, they
/// are those of the mean place where the light was scattered. Returns the transmittance of the
/// path.
template <class Visit>
dvec3 march(const Atmosphere& air, const dvec3& sun, const Way& way, int steps, bool hide,
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
    double middle = 0.5 * (before + now);
    if (hide) middle = std::lerp(before, now, mean_place(extinction.y * (now - before)));
    const double height = height_after(way.height, way.direction.y, middle);
    const double sun_cosine = (start * sun.y + middle * climb) / (kGroundRadius + height);
    visit(through * (1.0 - here) / glm::max(extinction, dvec3(1e-30)), mean, height, sun_cosine);
    through *= here;
    before = now;
    low = high;
  }
  return through;
}

/// Returns the light of a source that is even in direction. It is the light of two scatterings,
/// and that of all later ones as a geometric series of the share that one more scattering keeps.
dvec3 light_around(const Atmosphere& air, const SunPaths& paths, double height, double sun_cosine) {
  const dvec3 sun{std::sqrt(std::max(0.0, 1.0 - sun_cosine * sun_cosine)), sun_cosine, 0.0};
  dvec3 second(0.0), kept(0.0);
  for (int i = 0; i < kRings * kSectors; ++i) {
    Way way{height, sphere_direction(i / kSectors, i % kSectors), 0.0};
    way.length = way_to_the_end(height, way.direction.y);
    const dvec3 through = march(
        air, sun, way, kSteps, false,
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

/// Returns light without the false hue of a low sun. Three wavelengths stand for the spectrum
/// well for air masses up to about ten. A sun at the horizon passes many more, and then green
/// dominates as under no real sky, because molecules and ozone dim it least of the three. Green
/// is limited to little more than red or blue, and the light of deep twilight becomes grey. The
/// luminance stays the same.
dvec3 without_false_hue(const dvec3& light, double sun_sine) {
  constexpr dvec3 kLuminance{0.2126, 0.7152, 0.0722};
  constexpr double kMostGreen = 1.04;
  const double above = std::asin(std::clamp(sun_sine, -1.0, 1.0)) * (180.0 / kPi64);
  const double luminance = glm::dot(light, kLuminance);
  if (above >= 4.0 || luminance < 1e-290) return light;
  dvec3 hue = light;
  // Light that is green by its own colour keeps at least half of its green.
  hue.y = std::min(hue.y, std::max(kMostGreen * std::max(hue.x, hue.z), 0.5 * hue.y));
  hue =
      glm::mix(light, hue * (luminance / glm::dot(hue, kLuminance)), smooth_step(4.0, 0.0, above));
  return glm::mix(hue, dvec3(luminance), smooth_step(-11.0, -15.0, above));
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
    : air_(air),
      paths_(air),
      sun_(sun),
      around_(kHeights * kSuns),
      thick_share_(thick_haze_share(air)),
      scattered_extinction_(
          glm::mix(air.haze_extinction, reduced_haze_extinction(air), thick_share_)) {
  // Fog is too thin a layer to matter for the light of all the air.
  Atmosphere clear = air;
  clear.fog = {};
  tbb::parallel_for(0, kHeights * kSuns, [&](int i) {
    const double root = static_cast<double>(i / kSuns) / (kHeights - 1);
    const double share = static_cast<double>(i % kSuns) / (kSuns - 1);
    const double cosine = std::clamp(sun_.y + kSunReach * (2.0 * share - 1.0), -1.0, 1.0);
    around_[static_cast<std::size_t>(i)] =
        light_around(clear, paths_, kHighest * root * root, cosine);
  });
  if (thick_share_ <= 0.0) return;
  clear.haze_extinction = clear.haze_scattering = dvec3(0.0);
  const Scattering without(clear, sun);
  haze_light_.emplace(air, paths_, sun.y, [&without](double height, double sun_cosine) {
    return without.even_around(height, sun_cosine);
  });
}

dvec3 Scattering::sunlight(double height, double sun_cosine) const {
  return paths_.transmittance(height, sun_cosine) *
         (sun_share(height, sun_cosine) * fog_light(air_.fog, height, sun_cosine));
}

dvec3 Scattering::scattered_sunlight(double height, double sun_cosine) const {
  return paths_.transmittance(height, sun_cosine, scattered_extinction_) *
         (sun_share(height, sun_cosine) * fog_light(air_.fog, height, sun_cosine));
}

HazeLight::Field Scattering::around(double height, double sun_cosine) const {
  const HazeLight::Field light = spectral_around(height, sun_cosine);
  const dvec3 even = without_false_hue(light.even, sun_.y);
  return {even, light.slant * even / glm::max(light.even, dvec3(1e-300))};
}

HazeLight::Field Scattering::spectral_around(double height, double sun_cosine) const {
  if (thick_share_ <= 0.0) return {even_around(height, sun_cosine), dvec3(0.0)};
  const HazeLight::Field thick = haze_light_->at(height, sun_cosine);
  if (thick_share_ >= 1.0) return thick;
  return {glm::mix(even_around(height, sun_cosine), thick.even, thick_share_),
          thick_share_ * thick.slant};
}

dvec3 Scattering::even_around(double height, double sun_cosine) const {
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
      march(air_, sun_, way, steps, thick_share_ > 0.0,
            [&](const dvec3& share, const Density& mean, double height, double sun_cosine) {
              const dvec3 sun = scattered_sunlight(height, sun_cosine);
              const dvec3 single = sun * (air_.molecules * (mean.molecules * molecules) +
                                          air_.fog.extinction * mean.fog * fog);
              const HazeLight::Field around = spectral_around(height, sun_cosine);
              const dvec3 haze = air_.haze_scattering * mean.haze;
              light.add += share * (single + around.even * air_.scattering(mean) -
                                    way.direction.y * around.slant * haze);
              light.haze += share * sun * haze;
            });
  const dvec3 seen = light.add + haze_phase(towards, air_.haze_asymmetry) * light.haze;
  const dvec3 change = without_false_hue(seen, sun_.y) / glm::max(seen, dvec3(1e-300));
  light.add *= change;
  light.haze *= change;
  return light;
}

}  // namespace aerostat::air
