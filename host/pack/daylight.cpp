#include "pack/daylight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/smooth_step.hpp"

namespace aerostat::pack {
namespace {

dvec3 color(const float (&from)[3]) {
  return dvec3(from[0], from[1], from[2]);
}

}  // namespace

dvec3 daylight(const AeroScene& scene, double height_m) {
  const AeroAir& air = scene.air;
  const auto thinned = [height_m](float scale) {
    return std::exp(-std::clamp(height_m / static_cast<double>(scale), -60.0, 60.0));
  };
  const dvec3 depth = color(air.depth_ozone) +
                      color(air.depth_molecules) * thinned(air.molecules_height) +
                      color(air.depth_haze) * thinned(air.haze_height);
  const double from = static_cast<double>(air.sun_heights[0]);
  const double to = static_cast<double>(air.sun_heights[1]);
  const double t = std::clamp((height_m - from) / std::max(to - from, 1e-9), 0.0, 1.0);
  const double share = smooth_unit_step(t);
  const dvec3 sun = share / std::numbers::pi * glm::exp(-depth);
  return color(scene.sky.sun_irradiance) * (sun + color(air.ambient[0]));
}

}  // namespace aerostat::pack
