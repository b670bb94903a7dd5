#include "air/haze_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/parallel_for.h>

#include "core/smooth_step.hpp"

namespace aerostat::air {
namespace {

constexpr double kPi64 = std::numbers::pi;
constexpr int kLayers = 96, kSuns = 8;
// The optical depths between which one solution fades into the other. Chosen by eye. The usual
// scenes have a depth below a tenth, where both solutions agree within a tenth unless the sun is
// low.
constexpr double kThin = 0.12, kThick = 0.4;
// The largest share of the even part by which light going up or down may differ from it. With
// more, the linear law could fall below 0.
constexpr double kMostSlant = 0.8;
// The mean path of diffuse light through a level layer, divided by the thickness of the layer.
constexpr double kDiffuseWay = 1.66;

/// Returns the mean of exp(-x) over x from a to b.
double mean_transmittance(double a, double b) {
  const double least = std::min(a, b), rise = std::abs(b - a);
  return std::exp(-least) * (rise > 1e-6 ? -std::expm1(-rise) / rise : 1.0);
}

/// The effect of one layer on one channel, and the light in the layer.
struct Layer {
  double scattered = 0.0, absorbed = 0.0;  // optical depths; scattering counts as even
  double source = 0.0;                     // light that falls in, mean over all directions

  double depth() const { return scattered + absorbed; }
};

struct Ground {
  double albedo = 0.0, irradiance = 0.0;
};

/// The mean light and the flux (divided by 4 pi, positive upwards) of each layer, from the ground
/// up.
struct Diffusion {
  std::array<double, kLayers> mean{}, flux{};
};

/// Solves the diffusion of light through the layers. Between the middles of two layers, the flux
/// is the difference of their means divided by 3 times the depth between them. No light comes
/// down through the top. At the ground, the share `albedo` of the arriving light goes up again.
Diffusion solve(const std::array<Layer, kLayers>& layers, const Ground& ground) {
  const double kept = 1.0 - ground.albedo;
  const double to_ground = 2.0 * (1.0 + ground.albedo) + 1.5 * layers[0].depth() * kept;
  const double from_ground = ground.albedo * ground.irradiance / kPi64 / to_ground;
  std::array<double, kLayers + 1> open;  // flux through each face per difference of means
  open[0] = kept / to_ground;
  for (int i = 1; i < kLayers; ++i) {
    open[i] = 1.0 / (1.5 * (layers[i - 1].depth() + layers[i].depth()) + 1e-4);
  }
  open[kLayers] = 1.0 / (2.0 + 1.5 * layers[kLayers - 1].depth());
  // The elimination goes from the ground up. No row has a difference that could lose digits.
  Diffusion light;
  std::array<double, kLayers> rest, passed;
  double leak = open[0], inflow = from_ground;
  for (int i = 0; i < kLayers; ++i) {
    const double here = leak + layers[i].absorbed;
    rest[i] = here + open[i + 1];
    passed[i] = inflow + layers[i].scattered * layers[i].source;
    leak = open[i + 1] * here / rest[i];
    inflow = open[i + 1] * passed[i] / rest[i];
  }
  double above = 0.0;
  for (int i = kLayers - 1; i >= 0; --i) {
    above = light.mean[i] = (passed[i] + open[i + 1] * above) / rest[i];
  }
  for (int i = 0; i < kLayers; ++i) {
    const double below = i == 0 ? from_ground - open[0] * light.mean[0]
                                : open[i] * (light.mean[i - 1] - light.mean[i]);
    const double next = i + 1 < kLayers ? light.mean[i + 1] : 0.0;
    light.flux[i] = 0.5 * (below + open[i + 1] * (light.mean[i] - next));
  }
  return light;
}

}  // namespace

HazeLight::HazeLight(const Atmosphere& air, const SunPaths& paths, double sun,
                     const ClearLight& clear)
    : sun_(sun),
      first_(0.1 * std::min(air.haze_height, 1000.0)),
      growth_(std::log1p(kTopHeight / first_) / kLayers),
      columns_(kSuns) {
  tbb::parallel_for(0, kSuns, [&](int i) {
    const double share = static_cast<double>(i) / (kSuns - 1);
    const double cosine = std::clamp(sun + kSunReach * (2.0 * share - 1.0), -1.0, 1.0);
    columns_[static_cast<std::size_t>(i)] = column(air, paths, cosine, clear);
  });
}

double HazeLight::height_of(double level) const {
  return first_ * std::expm1(growth_ * level);
}

std::vector<HazeLight::Field> HazeLight::column(const Atmosphere& air, const SunPaths& paths,
                                                double sun_cosine, const ClearLight& clear) const {
  const dvec3 reduced = reduced_haze_extinction(air);
  const dvec3 absorption = air.haze_extinction - air.haze_scattering;
  // Returns the part of the light of the clear air above that comes down to a height.
  const auto skylight = [&](double height) {
    const double column = air.mean_density(height, kTopHeight).haze * (kTopHeight - height);
    return clear(height, sun_cosine) * glm::exp(-kDiffuseWay * column * reduced);
  };
  std::vector<Field> fields(kLayers);
  std::array<std::array<Layer, kLayers>, 3> layers;
  const dvec3 depth_to_ground = paths.depth(0.0, sun_cosine, reduced);
  dvec3 below = depth_to_ground;
  for (int i = 0; i < kLayers; ++i) {
    const double low = height_of(i), high = std::min(height_of(i + 1), kTopHeight);
    const double density = air.mean_density(low, high).haze * (high - low);
    const dvec3 above = paths.depth(high, sun_cosine, reduced);
    const double sun = 0.5 * (sun_share(low, sun_cosine) + sun_share(high, sun_cosine));
    fields[static_cast<std::size_t>(i)].even = skylight(height_of(i + 0.5));
    for (int c = 0; c < 3; ++c) {
      layers[c][i] = {(reduced[c] - absorption[c]) * density, absorption[c] * density,
                      sun * mean_transmittance(below[c], above[c]) / (4.0 * kPi64) +
                          fields[static_cast<std::size_t>(i)].even[c]};
    }
    below = above;
  }
  const dvec3 arriving =
      sun_share(0.0, sun_cosine) * std::max(sun_cosine, 0.0) * glm::exp(-depth_to_ground) +
      kPi64 * skylight(0.0);
  for (int c = 0; c < 3; ++c) {
    const Diffusion light = solve(layers[c], {air.ground_albedo[c], arriving[c]});
    for (int i = 0; i < kLayers; ++i) {
      Field& field = fields[static_cast<std::size_t>(i)];
      field.even[c] += light.mean[i];
      const double most = kMostSlant * field.even[c];
      field.slant[c] = std::clamp(3.0 * air.haze_asymmetry * light.flux[i], -most, most);
    }
  }
  return fields;
}

HazeLight::Field HazeLight::at(double height, double sun_cosine) const {
  const double level = std::log1p(std::max(height, 0.0) / first_) / growth_ - 0.5;
  const double row = std::clamp(level, 0.0, kLayers - 1.0);
  const double place =
      std::clamp(0.5 + 0.5 * (sun_cosine - sun_) / kSunReach, 0.0, 1.0) * (kSuns - 1);
  const auto i = static_cast<std::size_t>(std::min(row, kLayers - 2.0));
  const auto j = static_cast<std::size_t>(std::min(place, kSuns - 2.0));
  const double up = row - static_cast<double>(i), on = place - static_cast<double>(j);
  const auto between = [&](dvec3 Field::*part) {
    return glm::mix(glm::mix(columns_[j][i].*part, columns_[j + 1][i].*part, on),
                    glm::mix(columns_[j][i + 1].*part, columns_[j + 1][i + 1].*part, on), up);
  };
  return {between(&Field::even), between(&Field::slant)};
}

double thick_haze_share(const Atmosphere& air) {
  const dvec3& extinction = air.haze_extinction;
  const double most = std::max({extinction.x, extinction.y, extinction.z});
  const double depth = most * air.mean_density(0.0, kTopHeight).haze * kTopHeight;
  return smooth_step(kThin, kThick, depth);
}

dvec3 reduced_haze_share(const Atmosphere& air) {
  return 1.0 -
         air.haze_asymmetry * air.haze_scattering / glm::max(air.haze_extinction, dvec3(1e-30));
}

dvec3 reduced_haze_extinction(const Atmosphere& air) {
  return air.haze_extinction - air.haze_asymmetry * air.haze_scattering;
}

}  // namespace aerostat::air
