#pragma once

#include "core/math.hpp"

namespace aerostat::scene {

struct Camera;
struct Scene;

/// The size that a pixel in the middle of the picture covers at a distance from the eye. It is
/// angle_rad times the distance plus width_m. One of the two is 0.
struct PixelSize {
  double angle_rad = 0.0;
  double width_m = 0.0;

  double metres(double distance_m) const { return angle_rad * distance_m + width_m; }
  bool operator==(const PixelSize&) const = default;
};

/// Returns the size of a pixel. The scene need not be resolved.
PixelSize pixel_size(const Scene& scene);

/// Returns the point around which the world has most detail and precision. It is the eye, or the
/// target of an orthographic camera. The camera must have both.
dvec3 point_of_view(const Camera& camera);

}  // namespace aerostat::scene
