#include "map/map_view.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "scene/pixel_size.hpp"
#include "scene/scene.hpp"
#include "scene/view_axes.hpp"

namespace aerostat::map {
namespace {

constexpr double kStraight = 1e-9;  // the sine of the largest angle to the vertical

/// Returns a vector of the world as east and north.
dvec2 on_map(const dvec3& vector) {
  return {vector.x, -vector.z};
}

}  // namespace

dvec2 MapView::pixel_at(const dvec2& point) const {
  return glm::inverse(glm::dmat2(right, down)) * (point - corner);
}

MapView map_view(const scene::ResolvedScene& scene, const dvec2& first, const char* option) {
  const scene::ViewAxes axes = scene::view_axes(scene->camera);
  if (scene->camera.lens != scene::Lens::orthographic || !(axes.forward.y < 0.0) ||
      glm::length(on_map(axes.forward)) > kStraight) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: the picture is no map; expected /camera/lens orthographic and "
                            "/camera/target straight below /camera/position",
                            option));
  }
  const double pixel = scene::pixel_size(*scene).width_m;
  MapView view;
  // Adding 0 turns -0 into 0.
  view.right = pixel * on_map(axes.right) + 0.0;
  view.down = -pixel * on_map(axes.up) + 0.0;
  const dvec2 center = on_map({scene->terrain.center.x, 0.0, scene->terrain.center.y});
  const dvec2 steps = first + 0.5 - 0.5 * dvec2(scene->image.width, scene->image.height);
  view.corner = on_map(scene.eye()) - center + steps.x * view.right + steps.y * view.down;
  return view;
}

}  // namespace aerostat::map
