#include "scene/semantics.hpp"

#include <fmt/format.h>

namespace aerostat::scene::detail {

namespace {

bool is_null(const dvec3& v) {
  return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

void check_sun(const Json& document, const std::string& name) {
  if (!document.contains("sun")) return;
  const Json& sun = document["sun"];
  const auto direction = sun.find("direction");
  if (direction == sun.end()) return;
  for (const char* angle : {"azimuth_deg", "elevation_deg"}) {
    if (sun.contains(angle)) {
      fail(name, {"sun", angle}, "an angle beside /sun/direction",
           "either the direction or angles");
    }
  }
  if (is_null({(*direction)[0], (*direction)[1], (*direction)[2]})) {
    fail(name, {"sun", "direction"}, describe(*direction), "a vector that is not null");
  }
}

/// The ground under two points differs, so nothing can be said about a slanted line of sight yet.
bool sight_is_known(const Camera& camera) {
  const dvec3 sight = camera.target - camera.position;
  const bool given = camera.position_given && camera.target_given;
  const bool upright = sight.x == 0.0 && sight.z == 0.0;
  return given && (upright || camera.height_above != HeightReference::ground);
}

void check_camera(const Camera& camera, const std::string& name) {
  if (is_null(camera.up)) {
    fail(name, {"camera", "up"}, "[0, 0, 0]", "a vector that is not null");
  }
  if (!sight_is_known(camera)) return;
  const dvec3 sight = camera.target - camera.position;
  if (is_null(sight)) {
    fail(name, {"camera", "target"}, "the camera's own position", "another point");
  }
  const double sine = glm::length(glm::cross(glm::normalize(sight), glm::normalize(camera.up)));
  if (sine < 1e-6) {
    fail(name, {"camera", "up"}, "the direction in which the camera looks", "another direction");
  }
}

void check_order(const double (&range)[2], const char* key, const std::string& name) {
  if (range[0] <= range[1]) return;
  fail(name, {"biome", "ground", key}, fmt::format("[{}, {}]", range[0], range[1]),
       "the smaller one first");
}

}  // namespace

void check_semantics(const Json& document, const Scene& scene, const std::string& name) {
  check_sun(document, name);
  check_camera(scene.camera, name);
  check_order(scene.biome.ground.rock_slope_deg, "rock_slope_deg", name);
  check_order(scene.biome.ground.snow_slope_deg, "snow_slope_deg", name);
}

}  // namespace aerostat::scene::detail
