#include "scene/view_axes.hpp"

#include "core/error.hpp"
#include "core/unit_vector.hpp"
#include "scene/picture.hpp"

namespace aerostat::scene {
namespace {

/// The sine of the angle between view and up vector below which they count as parallel.
constexpr double kLeastSine = 1e-6;

bool is_parallel(const dvec3& a, const dvec3& b) {
  return glm::length(glm::cross(unit(a), unit(b))) < kLeastSine;
}

dvec3 up_of(const Camera& camera, const dvec3& view) {
  const dvec3 upright(0.0, 1.0, 0.0), north(0.0, 0.0, -1.0);
  if (!is_parallel(view, camera.up)) return camera.up;
  if (!is_parallel(view, upright)) return upright;
  return view.y < 0.0 ? north : -north;
}

}  // namespace

ViewAxes view_axes(const Camera& camera) {
  const dvec3 view = *camera.target - *camera.position;
  if (view == dvec3(0.0)) {
    throw Error(ErrorKind::bad_data,
                "/camera/target: found the camera's own position, expected another point");
  }
  ViewAxes axes;
  axes.forward = unit(view);
  const dvec3 up = up_of(camera, view);
  axes.right = glm::normalize(glm::cross(brought_to_one(view), brought_to_one(up)));
  axes.up = glm::cross(axes.right, axes.forward);
  if (camera.lens == Lens::panorama) {
    // A panorama keeps the up vector, so that upright things stay upright all around.
    axes.up = unit(camera.up);
    axes.forward = glm::cross(axes.up, axes.right);
  }
  return axes;
}

}  // namespace aerostat::scene
