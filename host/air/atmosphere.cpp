#include "air/atmosphere.hpp"

#include <algorithm>
#include <cmath>

#include "scene/scene.hpp"

namespace aerostat::air {
namespace {

constexpr double kPi64 = std::numbers::pi;

constexpr double kOzoneHeight = 25e3, kOzoneReach = 15e3;
// The optical depth of 300 Dobson units in each channel. It is the Chappuis band, averaged in the
// way of kWavelengths_um.
constexpr dvec3 kOzoneDepth{0.0396, 0.0249, 0.0};

double bounded(double exponent) {
  return std::clamp(exponent, -60.0, 60.0);
}

double ozone_density(double height) {
  return std::max(0.0, 1.0 - std::abs(height - kOzoneHeight) / kOzoneReach);
}

/// Returns the mean of exp(-x) over x from a to b, both at least -60.
double mean_exponential(double a, double b) {
  if (std::max(a, b) > 60.0) {
    const double least = std::min(a, b), rise = std::abs(b - a);
    return rise > 1e-6 ? std::exp(-least) * -std::expm1(-rise) / rise : std::exp(-least);
  }
  const double half = 0.5 * (b - a), square = half * half;
  const double middle = std::exp(-0.5 * (a + b));
  if (square < 0.25)
    return middle * (1.0 + square / 6.0 * (1.0 + square / 20.0 * (1.0 + square / 42.0)));
  return middle * std::sinh(half) / half;
}

/// Returns the antiderivative over x of the fog's density 1 / (1 + exp(x)).
double fog_column(double x) {
  return x > 0.0 ? -std::log1p(std::exp(-x)) : x - std::log1p(std::exp(x));
}

double fog_density(double x) {
  return 1.0 / (1.0 + std::exp(bounded(x)));
}

double mean_fog(double a, double b) {
  return std::abs(b - a) < 1e-4 ? fog_density(0.5 * (a + b))
                                : (fog_column(b) - fog_column(a)) / (b - a);
}

}  // namespace

double rayleigh_depth(double wavelength_um) {
  const double u2 = wavelength_um * wavelength_um;
  return 0.0021520 * (1.0455996 - 341.29061 / u2 - 0.90230850 * u2) /
         (1.0 + 0.0027059889 / u2 - 85.968563 * u2);
}

Density Atmosphere::density(double height) const {
  return mean_density(height, height);
}

Density Atmosphere::mean_density(double from, double to) const {
  const double a = std::max(from, 0.0), b = std::max(to, 0.0);
  Density mean;
  mean.molecules = mean_exponential(bounded(a / molecules_height), bounded(b / molecules_height));
  mean.haze = mean_exponential(a / haze_height, b / haze_height);
  mean.ozone = ozone_density(0.5 * (a + b));
  if (fog.extinction > 0.0) {
    mean.fog = mean_fog((from - fog.top) / fog.softness, (to - fog.top) / fog.softness);
  }
  return mean;
}

dvec3 Atmosphere::extinction(const Density& density) const {
  return molecules * density.molecules + haze_extinction * density.haze + ozone * density.ozone +
         fog.extinction * density.fog;
}

dvec3 Atmosphere::scattering(const Density& density) const {
  return molecules * density.molecules + haze_scattering * density.haze +
         fog.extinction * density.fog;
}

Atmosphere atmosphere_of(const scene::Scene& scene) {
  Atmosphere air;
  for (int i = 0; i < 3; ++i) {
    air.molecules[i] =
        scene.air.density * rayleigh_depth(kWavelengths_um[i]) / air.molecules_height;
  }
  const double haze = std::max(0.0, 3.912 / scene.haze.visibility_m - air.molecules.y);
  for (int i = 0; i < 3; ++i) {
    air.haze_extinction[i] =
        haze * std::pow(kWavelengths_um[i] / kWavelengths_um.y, -scene.haze.angstrom);
  }
  air.haze_scattering = air.haze_extinction * dvec3(scene.haze.albedo);
  air.haze_height = scene.haze.scale_height_m;
  air.haze_asymmetry = scene.haze.asymmetry;
  air.ozone = kOzoneDepth * (scene.air.ozone_du / 300.0 / kOzoneReach);
  air.ground_albedo = dvec3(scene.air.ground_albedo);
  if (scene.fog.enabled) {
    air.fog = {3.912 / scene.fog.visibility_m, scene.fog.top_m, scene.fog.softness_m};
  }
  return air;
}

double rayleigh_phase(double cosine) {
  return 3.0 / (16.0 * kPi64) * (1.0 + cosine * cosine);
}

double haze_phase(double cosine, double asymmetry) {
  const double g2 = asymmetry * asymmetry;
  const double spread = 1.0 + g2 - 2.0 * asymmetry * cosine;
  return 3.0 / (8.0 * kPi64) * (1.0 - g2) * (1.0 + cosine * cosine) /
         ((2.0 + g2) * spread * std::sqrt(spread));
}

double distance_to_height(double from, double cosine, double to) {
  const double r = kGroundRadius + from;
  // The height (R + to)^2 - r^2 is computed without the difference of large squares.
  const double rise = (to - from) * (2.0 * kGroundRadius + to + from);
  const double square = r * r * cosine * cosine + rise;
  if (square < 0.0) return std::numeric_limits<double>::infinity();
  const double root = std::sqrt(square);
  if (rise > 0.0) return cosine > 0.0 ? rise / (r * cosine + root) : root - r * cosine;
  if (cosine >= 0.0) return rise == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  return -rise / (root - r * cosine);
}

double height_after(double from, double cosine, double distance) {
  const double r = kGroundRadius + from;
  const double rise = distance * (2.0 * r * cosine + distance);
  return from + rise / (std::sqrt(std::max(0.0, r * r + rise)) + r);
}

}  // namespace aerostat::air
