#include "air/sun_paths.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "core/smooth_step.hpp"

namespace aerostat::air {
namespace {

constexpr int kHeights = 64, kDirections = 128, kSteps = 48;
// The scale height below which the rows of the table are too far apart for haze.
constexpr double kResolvedHeight = 500.0;

// Returns the distance in metres from a height to the horizon that is seen from there.
double horizon_of(double height) {
  return std::sqrt(height * (2.0 * kGroundRadius + height));
}

Columns integrate(const Atmosphere& air, double height, double cosine, double distance) {
  Columns sum;
  double before = 0.0, low = height;
  for (int i = 1; i <= kSteps; ++i) {
    // Steps are short at the near end, where the air is dense.
    const double share = static_cast<double>(i) / kSteps;
    const double now = distance * share * share;
    const double high = height_after(height, cosine, now);
    const Density mean = air.mean_density(low, high);
    sum.molecules += mean.molecules * (now - before);
    sum.haze += mean.haze * (now - before);
    sum.ozone += mean.ozone * (now - before);
    before = now;
    low = high;
  }
  return sum;
}

/// Returns the cosine with the upright of a line of sight. Its distance to the top of the air
/// lies at `share` between the shortest distance and the one along the horizon.
double cosine_at(double height, double share) {
  const double top = horizon_of(kTopHeight);
  const double least = kTopHeight - height, most = horizon_of(height) + top;
  const double distance = least + share * (most - least);
  const double r = kGroundRadius + height;
  const double rise = (kTopHeight - height) * (2.0 * kGroundRadius + kTopHeight + height);
  return distance <= 0.0
             ? 1.0
             : std::clamp((rise - distance * distance) / (2.0 * r * distance), -1.0, 1.0);
}

struct Place {
  int index;
  double share;
};

Place place(double x, int count) {
  const double at = std::clamp(x, 0.0, 1.0) * (count - 1);
  const int index = std::min(static_cast<int>(at), count - 2);
  return {index, at - index};
}

Columns mix(const Columns& a, const Columns& b, double t) {
  return {std::lerp(a.molecules, b.molecules, t), std::lerp(a.haze, b.haze, t),
          std::lerp(a.ozone, b.ozone, t)};
}

}  // namespace

SunPaths::SunPaths(const Atmosphere& air) : air_(air), table_(kHeights * kDirections) {
  const double top = horizon_of(kTopHeight);
  tbb::parallel_for(0, kHeights, [&](int row) {
    const double horizon = top * row / (kHeights - 1);
    const double height =
        horizon * horizon /
        (std::sqrt(kGroundRadius * kGroundRadius + horizon * horizon) + kGroundRadius);
    for (int i = 0; i < kDirections; ++i) {
      const double cosine = cosine_at(height, static_cast<double>(i) / (kDirections - 1));
      const double distance = distance_to_height(std::min(height, kTopHeight), cosine, kTopHeight);
      table_[static_cast<std::size_t>(row * kDirections + i)] =
          integrate(air, height, cosine, distance);
      table_[static_cast<std::size_t>(row * kDirections + i)].haze *= thin_layer(height);
    }
  });
}

double SunPaths::thin_layer(double height) const {
  if (air_.haze_height >= kResolvedHeight) return 1.0;
  return std::exp(std::min(height / air_.haze_height, 60.0));
}

Columns SunPaths::columns(double height, double cosine) const {
  const double h = std::clamp(height, 0.0, kTopHeight);
  const double least = kTopHeight - h;
  const double most = horizon_of(h) + horizon_of(kTopHeight);
  const double distance = distance_to_height(h, cosine, kTopHeight);
  const Place row = place(horizon_of(h) / horizon_of(kTopHeight), kHeights);
  const Place at = place((distance - least) / std::max(most - least, 1.0), kDirections);
  const Columns* low = table_.data() + row.index * kDirections + at.index;
  const Columns* high = low + kDirections;
  Columns found = mix(mix(low[0], low[1], at.share), mix(high[0], high[1], at.share), row.share);
  found.haze /= thin_layer(h);
  return found;
}

dvec3 SunPaths::transmittance(double height, double cosine) const {
  return transmittance(height, cosine, air_.haze_extinction);
}

dvec3 SunPaths::transmittance(double height, double cosine, const dvec3& haze_extinction) const {
  return glm::exp(-depth(height, cosine, haze_extinction));
}

dvec3 SunPaths::depth(double height, double cosine, const dvec3& haze_extinction) const {
  const Columns way = columns(height, cosine);
  return air_.molecules * way.molecules + haze_extinction * way.haze + air_.ozone * way.ozone;
}

double sun_share(double height, double cosine) {
  const double h = std::max(height, 0.0);
  const double horizon = -std::acos(kGroundRadius / (kGroundRadius + h));
  const double above = std::asin(std::clamp(cosine, -1.0, 1.0)) - horizon;
  return smooth_unit_step(std::clamp(0.5 + 0.5 * above / kSunRadius, 0.0, 1.0));
}

double fog_light(const FogLayer& fog, double height, double sun_cosine) {
  if (fog.extinction <= 0.0) return 1.0;
  const double x = (height - fog.top) / fog.softness;
  const double above = x > 0.0 ? std::log1p(std::exp(-x)) : std::log1p(std::exp(x)) - x;
  const double depth = fog.extinction * fog.softness * above / std::max(sun_cosine, kLowestFogSun);
  return 1.0 / (1.0 + 0.75 * (1.0 - kFogAsymmetry) * depth);
}

}  // namespace aerostat::air
