#include "world/surface.hpp"

#include <algorithm>

#include "scene/scene.hpp"
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

bool same_land(const scene::Scene& a, const scene::Scene& b) {
  const scene::Water &one = a.biome.water, &other = b.biome.water;
  return without_drape(a.terrain) == without_drape(b.terrain) && one.enabled == other.enabled &&
         one.level_m == other.level_m;
}

}  // namespace aerostat::world
