#include "world/surface.hpp"

#include <algorithm>

#include "scene/scene.hpp"
#include "terrain/height_field.hpp"

namespace aerostat::world {

struct Surface::State {
  terrain::HeightField field;
  scene::Water water;
  dvec2 center;
  double fall;

  double sea_level(double x, double z) const {
    const dvec2 away = dvec2(x, z) - center;
    return water.level_m - fall * glm::dot(away, away);
  }
};

Surface::Surface(const scene::Scene& scene, Carving carving)
    : state_(std::make_shared<const State>(State{terrain::HeightField(scene.terrain, carving),
                                                 scene.biome.water, scene.terrain.center,
                                                 scene::ground_fall(scene.terrain)})) {}

Surface::Surface(const scene::Scene& scene, Carving carving, ReliefCache& reliefs)
    : state_(std::make_shared<const State>(
          State{terrain::HeightField(scene.terrain, carving, reliefs), scene.biome.water,
                scene.terrain.center, scene::ground_fall(scene.terrain)})) {}

double Surface::height(double x, double z, double spacing) const {
  const terrain::HeightField& field = state_->field;
  const auto water = field.water_level(x, z, spacing);
  const double ground = water ? *water : field.height(x, z, spacing);
  return state_->water.enabled ? std::max(ground, state_->sea_level(x, z)) : ground;
}

bool same_land(const scene::Scene& a, const scene::Scene& b) {
  const scene::Water &one = a.biome.water, &other = b.biome.water;
  return without_drape(a.terrain) == without_drape(b.terrain) && one.enabled == other.enabled &&
         one.level_m == other.level_m;
}

}  // namespace aerostat::world
