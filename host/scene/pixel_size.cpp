#include "scene/pixel_size.hpp"

#include <cmath>
#include <numbers>

#include "scene/scene.hpp"

namespace aerostat::scene {

PixelSize pixel_size(const Scene& scene) {
  const double height = scene.image.height;
  switch (scene.camera.lens) {
    case Lens::panorama:
      return {std::numbers::pi / height, 0.0};
    case Lens::orthographic:
      return {0.0, scene.camera.view_height_m / height};
    case Lens::pinhole:
    case Lens::thin_lens:
      break;
  }
  return {2.0 * std::tan(scene.camera.fov_y_deg * (std::numbers::pi / 360.0)) / height, 0.0};
}

dvec3 point_of_view(const Camera& camera) {
  return camera.lens == Lens::orthographic ? *camera.target : *camera.position;
}

}  // namespace aerostat::scene
