#include "world/surface.hpp"

#include <algorithm>

#include "terrain/height_field.hpp"

namespace aerostat::world {

struct Surface::State {
  terrain::HeightField field;
  scene::Water water;
};

Surface::Surface(const scene::Scene& scene, Carving carving)
    : state_(std::make_shared<const State>(
          State{terrain::HeightField(scene.terrain, carving), scene.biome.water})) {}

Surface::Surface(const scene::Scene& scene, Carving carving, ReliefCache& reliefs)
    : state_(std::make_shared<const State>(
          State{terrain::HeightField(scene.terrain, carving, reliefs), scene.biome.water})) {}

double Surface::height(double x, double z, double spacing) const {
  const double ground = state_->field.height(x, z, spacing);
  return state_->water.enabled ? std::max(ground, state_->water.level_m) : ground;
}

}  // namespace aerostat::world
