#include "model/balloon.hpp"
#include "world/surface.hpp"
#include "world/world.hpp"

namespace aerostat::world {
namespace {

/// How far ahead the passenger looks, and how much the view dips below the horizon.
constexpr double kBasketLookAhead_m = 100.0;
constexpr double kBasketDip_deg = 7.0;

/// What heights at a point count from. The balloon's height must be known already.
double reference_height(const scene::Scene& scene, const Surface& surface,
                        scene::HeightReference reference, const dvec3& at) {
  switch (reference) {
    case scene::HeightReference::sea:
      return 0.0;
    case scene::HeightReference::ground:
      return surface.height(at.x, at.z);
    case scene::HeightReference::balloon:
      return scene.balloon.position.y;
  }
  return 0.0;
}

void settle_height(const Surface& surface, scene::Balloon& balloon) {
  if (balloon.height_above != scene::HeightReference::ground) return;
  balloon.position.y += surface.height(balloon.position.x, balloon.position.z);
  balloon.height_above = scene::HeightReference::sea;
}

void look_from_basket(scene::Scene& scene) {
  scene::Camera& camera = scene.camera;
  const dvec3 eye = model::basket_eye(scene.balloon);
  if (!camera.position_given) camera.position = eye;
  if (!camera.target_given) {
    const double heading = glm::radians(scene.balloon.heading_deg);
    const double dip = std::tan(glm::radians(kBasketDip_deg));
    camera.target =
        camera.position + kBasketLookAhead_m * dvec3(std::sin(heading), -dip, -std::cos(heading));
  }
}

}  // namespace

void resolve(scene::Scene& scene) {
  const Surface surface(scene);
  settle_height(surface, scene.balloon);
  for (scene::Balloon& further : scene.balloons) settle_height(surface, further);
  scene::Camera& camera = scene.camera;
  if (camera.position_given) {
    camera.position.y += reference_height(scene, surface, camera.height_above, camera.position);
  }
  if (camera.target_given) {
    camera.target.y += reference_height(scene, surface, camera.height_above, camera.target);
  }
  camera.height_above = scene::HeightReference::sea;
  if (camera.view == scene::View::basket) look_from_basket(scene);
  camera.position_given = camera.target_given = true;
}

}  // namespace aerostat::world
