#pragma once

#include "scene/scene.hpp"

namespace aerostat::scene {

/// How much a pixel in the middle of the picture covers at a distance from the eye: angle_rad of it
/// and width_m beside. One of them is 0.
struct PixelSize {
  double angle_rad = 0.0;
  double width_m = 0.0;

  double metres(double distance_m) const { return angle_rad * distance_m + width_m; }
  bool operator==(const PixelSize&) const = default;
};

PixelSize pixel_size(const Scene& scene);

/// Around which point the world is to be rich and precise: the eye, or an orthographic camera's
/// target.
dvec3 point_of_view(const Camera& camera);

}  // namespace aerostat::scene
