#include "labels/projection.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/pixel_size.hpp"
#include "scene/scene.hpp"

namespace aerostat::labels {

Projection::Projection(const scene::ResolvedScene& scene)
    : eye_(scene.eye()),
      axes_(scene::view_axes(scene->camera)),
      lens_(scene->camera.lens),
      size_(scene->image.width, scene->image.height) {
  const scene::PixelSize pixel = scene::pixel_size(*scene);
  angle_rad_ = pixel.angle_rad;
  width_m_ = pixel.width_m;
}

std::optional<Projected> Projection::of(const dvec3& point) const {
  const dvec3 way = point - eye_;
  const double right = glm::dot(way, axes_.right), up = glm::dot(way, axes_.up),
               ahead = glm::dot(way, axes_.forward), distance = glm::length(way);
  if (!(distance > 0.0)) return std::nullopt;
  if (lens_ == scene::Lens::panorama) {
    const double turn = std::atan2(right, ahead) / (2.0 * std::numbers::pi);
    const double rise = std::asin(std::clamp(up / distance, -1.0, 1.0)) / std::numbers::pi;
    return Projected{size_ * dvec2(0.5 + turn, 0.5 - rise), distance};
  }
  if (!(ahead > 0.0)) return std::nullopt;
  const bool parallel = lens_ == scene::Lens::orthographic;
  const double pixel = parallel ? width_m_ : angle_rad_ * ahead;
  return Projected{0.5 * size_ + dvec2(right, -up) / pixel, parallel ? ahead : distance};
}

dvec3 Projection::eye_for(const dvec3& point) const {
  if (lens_ != scene::Lens::orthographic) return eye_;
  return point - axes_.forward * glm::dot(point - eye_, axes_.forward);
}

}  // namespace aerostat::labels
