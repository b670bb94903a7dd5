#include "world/surface.hpp"

#include <algorithm>

#include "terrain/height_field.hpp"

namespace aerostat::world {

struct Surface::State {
  terrain::HeightField field;
  scene::Water water;
};

Surface::Surface(const scene::Scene& scene)
    : state_(std::make_shared<const State>(
          State{terrain::HeightField(scene.terrain), scene.biome.water})) {}

double Surface::height(double x, double z) const {
  const double ground = state_->field.height(x, z);
  return state_->water.enabled ? std::max(ground, state_->water.level_m) : ground;
}

}  // namespace aerostat::world
