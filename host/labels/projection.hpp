#pragma once

#include <optional>

#include "core/math.hpp"
#include "scene/picture.hpp"
#include "scene/resolved_scene.hpp"
#include "scene/view_axes.hpp"

namespace aerostat::labels {

/// Where a point of the world is seen.
struct Projected {
  dvec2 pixel{0.0};  // from the upper left corner; the middle of the first pixel is at 0.5, 0.5
  double distance_m = 0.0;  // along the ray
};

/// The inverse of a scene's eye rays, for every lens. A thin lens counts as a pinhole in its
/// middle.
class Projection {
 public:
  explicit Projection(const scene::ResolvedScene& scene);

  /// Returns where a point is seen, which may be beyond the picture, or nothing if it lies behind
  /// the camera or at the eye.
  std::optional<Projected> of(const dvec3& point) const;

  /// Returns the point from which a point is seen, which is the eye unless rays are parallel.
  dvec3 eye_for(const dvec3& point) const;

  /// The side of a pixel at a distance, in metres.
  double pixel_m(double distance_m) const { return angle_rad_ * distance_m + width_m_; }

 private:
  dvec3 eye_;
  scene::ViewAxes axes_;
  scene::Lens lens_;
  dvec2 size_;  // of the picture in pixels
  double angle_rad_, width_m_;
};

}  // namespace aerostat::labels
