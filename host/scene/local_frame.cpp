#include "scene/local_frame.hpp"

#include <cmath>

#include "scene/balloons.hpp"
#include "scene/pixel_size.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene {
namespace {

/// Coordinates below 8192 m are exact to half a millimetre in single precision.
constexpr double kNear_m = 8192.0;
constexpr double kStep_m = 4096.0;

double stepped(double place) {
  return std::abs(place) < kNear_m ? 0.0 : kStep_m * std::round(place / kStep_m);
}

}  // namespace

dvec3 origin_near(const Scene& scene, const dvec3& position) {
  const dvec2& center = scene.terrain.center;
  const dvec3 place = place_of(scene, position);
  return {center.x + stepped(place.x), stepped(place.y), center.y + stepped(place.z)};
}

dvec3 origin_for(const Scene& scene) {
  return origin_near(scene, point_of_view(scene.camera));
}

dvec3 origin_for_export(const ResolvedScene& scene) {
  const Terrain& terrain = scene->terrain;
  const dvec3 center(terrain.center.x, terrain.base_m, terrain.center.y);
  const auto balloons = balloons_of(*scene);
  return origin_near(*scene, balloons.empty() ? center : balloons.front()->position);
}

dvec3 place_of(const Scene& scene, const dvec3& position) {
  const dvec2& center = scene.terrain.center;
  return position - dvec3(center.x, 0.0, center.y);
}

Scene counted_from_origin(const ResolvedScene& scene) {
  const dvec3& origin = scene.origin();
  Scene local = *scene;
  local.terrain.center -= dvec2(origin.x, origin.z);
  local.terrain.base_m -= origin.y;
  local.biome.water.level_m -= origin.y;
  for (Balloon* balloon : all_balloons(local)) balloon->position -= origin;
  *local.camera.position -= origin;
  *local.camera.target -= origin;
  for (PointLight& light : local.lights) light.position -= origin;
  for (PlacedModel& model : local.objects) {
    const bool from_sea = model.height_above == HeightReference::sea;
    model.position -= dvec3(origin.x, from_sea ? origin.y : 0.0, origin.z);
  }
  return local;
}

}  // namespace aerostat::scene
