#include "world/resolve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "model/balloon.hpp"
#include "scene/balloons.hpp"
#include "scene/field_rule.hpp"
#include "scene/local_frame.hpp"
#include "scene/scene.hpp"
#include "scene/view_axes.hpp"
#include "terrain/terrain_mesh.hpp"

namespace aerostat::world {
namespace {

/// Returns the height in metres above the sea on which one stands at a place.
using HeightAt = std::function<double(double x, double z)>;

/// The distance at which the passenger looks, and how far the view dips below the horizon.
constexpr double kBasketLookAhead_m = 100.0;
constexpr double kBasketDip_deg = 7.0;
constexpr double kEyeClearance_m = 2.0;

/// Returns the two ends of the cell of a graded axis that holds a place, or of the nearest cell.
std::pair<double, double> cell_at(const std::vector<double>& axis, double place) {
  const auto next = std::upper_bound(axis.begin() + 1, axis.end() - 1, place);
  return {*(next - 1), *next};
}

/// Returns the height of a cell's mesh at shares u and v of its sides. It holds for both ways of
/// cutting the cell into triangles.
double mesh_height(const std::array<double, 4>& corners, double u, double v) {
  const auto [h00, h10, h01, h11] = corners;
  const double one =
      u > v ? h00 + u * (h10 - h00) + v * (h11 - h10) : h00 + v * (h01 - h00) + u * (h11 - h01);
  const double other = u + v < 1.0 ? h00 + u * (h10 - h00) + v * (h01 - h00)
                                   : h11 + (1.0 - u) * (h01 - h11) + (1.0 - v) * (h10 - h11);
  return std::max(one, other);
}

/// Returns the height from which heights at a point count. The balloon's height must be known.
double reference_height(const scene::Scene& scene, const HeightAt& ground,
                        scene::HeightReference reference, const dvec3& at) {
  switch (reference) {
    case scene::HeightReference::sea:
      return 0.0;
    case scene::HeightReference::ground:
      return ground(at.x, at.z);
    case scene::HeightReference::balloon:
      return scene.balloon.position.y;
  }
  return 0.0;
}

/// Throws Error{bad_data} for a place above the sea that no scene file could give at `pointer`.
void check_place(const std::string& pointer, const dvec3& place) {
  const double most_m = scene::field_rule(pointer).maximum;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(place[axis]) <= most_m) continue;
    throw Error(ErrorKind::bad_data,
                fmt::format("{}/{}: found {} m, with all heights above the sea, expected {} to {}",
                            pointer, axis, place[axis], -most_m, most_m));
  }
}

void check_places(const scene::Scene& scene) {
  check_place("/balloon/position", scene.balloon.position);
  for (std::size_t i = 0; i < scene.balloons.size(); ++i) {
    check_place(fmt::format("/balloons/{}/position", i), scene.balloons[i].position);
  }
  check_place("/camera/position", *scene.camera.position);
  check_place("/camera/target", *scene.camera.target);
}

/// Makes the height of a balloon or a light count from the sea.
template <class Placed>
void settle_height(const HeightAt& ground, Placed& placed) {
  if (placed.height_above != scene::HeightReference::ground) return;
  placed.position.y += ground(placed.position.x, placed.position.z);
  placed.height_above = scene::HeightReference::sea;
}

void settle_lights(const HeightAt& ground, scene::Scene& scene) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    scene::PointLight& light = scene.lights[i];
    if (light.height_above == scene::HeightReference::sea) continue;
    settle_height(ground, light);
    check_place(fmt::format("/lights/{}/position", i), light.position);
  }
}

/// Puts the eye into the basket, and the target straight ahead, where the scene gives none.
void look_from_basket(scene::Scene& scene) {
  scene::Camera& camera = scene.camera;
  if (!camera.position) camera.position = model::basket_eye(scene.balloon);
  if (!camera.target) {
    const double heading = glm::radians(scene.balloon.heading_deg);
    const double dip = std::tan(glm::radians(kBasketDip_deg));
    camera.target =
        *camera.position + kBasketLookAhead_m * dvec3(std::sin(heading), -dip, -std::cos(heading));
  }
}

/// Returns the height of the land's mesh of at most `cells` cells a side at a place.
double mesh_height_at(const scene::Terrain& terrain, const Surface& surface, int cells,
                      const dvec2& position) {
  const auto axis =
      terrain::graded_axis(std::min(terrain.cells, cells), terrain.size_m, terrain.grading);
  const dvec2 place = position - terrain.center;
  const auto [x0, x1] = cell_at(axis, place.x);
  const auto [z0, z1] = cell_at(axis, place.y);
  const auto corner = [&, spacing = std::max(x1 - x0, z1 - z0)](double x, double z) {
    return surface.height(x + terrain.center.x, z + terrain.center.y, spacing);
  };
  return mesh_height({corner(x0, z0), corner(x1, z0), corner(x0, z1), corner(x1, z1)},
                     std::clamp((place.x - x0) / (x1 - x0), 0.0, 1.0),
                     std::clamp((place.y - z0) / (z1 - z0), 0.0, 1.0));
}

}  // namespace

/// The only maker of resolved scenes.
class Resolver {
 public:
  static scene::ResolvedScene resolve(scene::Scene scene, const HeightAt& ground) {
    scene::hold_festival(scene);
    for (scene::Balloon* balloon : scene::all_balloons(scene)) settle_height(ground, *balloon);
    settle_lights(ground, scene);
    scene::Camera& camera = scene.camera;
    for (std::optional<dvec3>* point : {&camera.position, &camera.target}) {
      if (*point) (*point)->y += reference_height(scene, ground, camera.height_above, **point);
    }
    camera.height_above = scene::HeightReference::sea;
    look_from_basket(scene);
    check_places(scene);
    scene::view_axes(camera);  // Throws if the camera has no view.
    return with_origin(std::move(scene));
  }

  static scene::ResolvedScene lifted(scene::Scene scene, double lift_m) {
    scene.camera.position->y += lift_m;
    scene.camera.target->y += lift_m;
    return with_origin(std::move(scene));
  }

 private:
  static scene::ResolvedScene with_origin(scene::Scene scene) {
    const dvec3 origin = scene::origin_for(scene);
    return {std::move(scene), origin};
  }
};

scene::ResolvedScene resolve(scene::Scene scene) {
  ReliefCache reliefs;
  return resolve(std::move(scene), reliefs);
}

scene::ResolvedScene resolve(scene::Scene scene, ReliefCache& reliefs) {
  std::optional<Surface> surface;
  const auto ground = [&surface, &reliefs, land = scene](double x, double z) {
    if (!surface) surface.emplace(land, Carving::fine, reliefs);
    return surface->height(x, z);
  };
  return Resolver::resolve(std::move(scene), ground);
}

scene::ResolvedScene resolve(scene::Scene scene, const Surface& surface) {
  return Resolver::resolve(std::move(scene),
                           [&surface](double x, double z) { return surface.height(x, z); });
}

scene::ResolvedScene with_eye_unburied(const scene::ResolvedScene& scene, const Surface& surface,
                                       int cells) {
  const dvec3& eye = scene.eye();
  const double mesh = mesh_height_at(scene->terrain, surface, cells, {eye.x, eye.z});
  const double least = kEyeClearance_m + std::max(mesh, surface.height(eye.x, eye.z));
  return Resolver::lifted(*scene, std::max(0.0, least - eye.y));
}

}  // namespace aerostat::world
