#include "scene/balloons.hpp"

#include "scene/scene.hpp"

namespace aerostat::scene {

std::vector<const Balloon*> balloons_of(const Scene& scene) {
  std::vector<const Balloon*> balloons;
  if (scene.balloon.enabled) balloons.push_back(&scene.balloon);
  for (const Balloon& further : scene.balloons) {
    if (further.enabled) balloons.push_back(&further);
  }
  return balloons;
}

std::vector<Balloon*> all_balloons(Scene& scene) {
  std::vector<Balloon*> balloons{&scene.balloon};
  for (Balloon& further : scene.balloons) balloons.push_back(&further);
  return balloons;
}

}  // namespace aerostat::scene
